// Corners between legs that bend: straight legs stay prisms, and both sides meet in the plane
// that halves the angle.
let ring = circle((0, 0, 0), 0.1, normal = (1, 0, 0))
curve bent = join([line((0, 0, 0), (2, 0, 0)), line((2, 0, 0), (2, 2, 0)), arc_through((2, 2, 0), (3 - sqrt(1/2), 2 + sqrt(1/2), 0), (3, 3, 0)), line((3, 3, 0), (5, 5, 0))])
surface gutter = sweep(ring, bent, corner = "miter")
let made = report(gutter)
print made.corners, made.deviation.max < 1e-6
let at_corner = [for u in linspace(0, 1, 9): gutter(u, made.corners[0])]
check every(at_corner, p => dot(p - (2, 0, 0), (1, 1, 0)) ~= 0 within 1e-12)
check every(linspace(0, 1, 9), u => every([0.3, 0.9], f => {
    let p = gutter(u, bent.domain.start + f*(made.corners[0] - bent.domain.start))
    hypot(p.y, p.z) ~= 0.1 within 1e-6
}))
// The same as the exact one along a polygon.
let zigzag = polyline((0, 0, 0), (3, 0, 0), (3, 2, 0), (3, 2, 4))
surface exact = sweep(ring, zigzag, corner = "miter")
surface moved = sweep(ring, zigzag, corner = "miter", scale = 1)
check every(linspace(0, 1, 9), u => every(linspace(0, 1, 13), f => {
    let v = lerp(zigzag.domain.start, zigzag.domain.end, f)
    norm(exact(u, v) - moved(u, v)) < 1e-9
}))

// Two rails hold both ends of a section.
let tape = bezier((0, -1, 0), (0, 0, 1), (0, 1, 0))
let left = bezier((0, -1, 0), (2, -2, 0), (5, -0.5, 1))
let right = bezier((0, 1, 0), (2, 1.5, 0), (5, 1, 2))
surface roof = sweep(tape, line((0, 0, 0), (5, 0, 0)), rail = [left, right])
check every(linspace(0, 1, 11), v => norm(roof(0, v) - left(v)) < 1e-6 and norm(roof(1, v) - right(v)) < 1e-6)
// The rise stays half of the width.
check every(linspace(0, 1, 11), v => norm(roof(0.5, v) - lerp(left(v), right(v), 0.5)) ~= 0.25*norm(right(v) - left(v)) within 1e-5)

// A closed skin along a closed spine.
let spine = circle((0, 0, 0), 5)
fn rim(k) = circle((5*cos(90deg*k), 5*sin(90deg*k), 0), 1, normal = (-sin(90deg*k), cos(90deg*k), 0))
surface ring_of_it = skin([for k in 0..3: rim(k)], closed = true, spine = spine, at = [0, 0.25, 0.5, 0.75, 1])
check every(linspace(0, 1, 9), u => norm(ring_of_it(u, 0) - ring_of_it(u, 1)) < 1e-14)
check every(linspace(0, 1, 9), u => {
    let slopes = [for v in [0, 1]: derivative(ring_of_it, u, v, du = 0, dv = 1)]
    norm(slopes[0] - slopes[1]) < 1e-12 and abs(cross(slopes[0], (0, 1, 0)).x) < 1e-12
})
