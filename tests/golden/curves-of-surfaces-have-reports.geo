unit mm
// What `intersect`, `section` and `edges` give is told of: whether it is proven, and how far from the surfaces it may be.
surface ball = sphere((0, 0), 2)
surface tube = cylinder((1, 0, -3), 1.2, 6)
surface vault = bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 4), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]])
// The distance from a curve to a surface at its curve of parameters, where they are one beside the other.
fn off(c, s, on) = max([for t in linspace(c.domain.start, c.domain.end, 101): { let p = on(t)  distance(s(p.x, p.y), c(t)) }])
fn holds(c, sides) = {
    let r = report(c)
    r.proven and every([0, 1], i => off(c, sides[i], r.on[i]) <= r.deviation)
}
let meetings = intersect(ball, tube)
check every(meetings, c => holds(c, [ball, tube]))
check every(intersect(vault, sphere((2, 2, 1), 1)), c => holds(c, [vault, sphere((2, 2, 1), 1)]))
let first = report(meetings[0])
print first.kind, first.between, first.deviation <= 1e-6, first.radius < 16e-6

let slices = [for c in section(tube, plane((0, 0, 0), (0, 1, 1))): report(c)]
check every(slices, r => r.proven and r.deviation <= 1e-6 and r.radius <= 1e-6)
print slices[0].operation, slices[0].kind

// The border of a face, and the edges of a solid.
let cap = split(vault, by = sphere((2, 2, 1), 1))[0]
check every(edges(cap), e => report(e).proven and every(report(e).on, on => off(trim(e, on.domain), vault, on) <= report(e).deviation))
solid can = solid(cylinder((0, 0), 1, 3), cap = true)
print [for e in edges(cut(can, plane((0, 0, 1), (0.2, 0.3, 1)))): report(e).kind]
check every(edges(can), e => report(e).proven)

// Nothing is proven of a touch, and of a function.
print [for c in section(torus((0, 0), 3, 1), plane((0, 0, 1), (0, 0, 1))): [report(c).kind, report(c).proven]]
surface wave = parametric((u, v) => (u, v, v*sin(u*1rad)), 0..4, 0..1)
print report(section(wave, plane((0, 0.5, 0), (0, 1, 0)))[0])
