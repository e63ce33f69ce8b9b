// Sections, contours and intersections that break other programs, by name.

fn level(z) = plane((0, 0, z), (0, 0, 1))
fn total(lines) = sum([for c in lines: length(c)])

test "a plane tangent to a torus: the circle on top, a figure of eight inside" {
    let ring = torus((0, 0), 3, 1)
    check [for c in section(ring, level(1)): length(c)] ~= [6*pi] within 1e-5
    let eight = section(ring, plane((2, 0), (1, 0, 0)))
    check every(eight, c => c.closed) and every(eight, c => c.start ~= (2, 0, 0) within 1e-6)
    check total(intersect(ring, plane_patch((-9, -9, 1), (18, 0), (0, 18)))) ~= 6*pi within 1e-5
}

test "a plane through both poles of a sphere, and one tangent to it there" {
    let ball = sphere((0, 0), 2)
    check total(section(ball, plane((0, 0), (1, 2, 0)))) ~= 4*pi within 1e-5
    check section(ball, level(2)) == []
    check total(intersect(ball, plane_patch((0, -9, -9), (0, 18), (0, 0, 18)))) ~= 4*pi within 1e-5
}

test "a plane that holds an isocurve, and a patch" {
    let pipe = cylinder((0, 0), 1, 2)
    check total(section(pipe, plane((0, 0), (0, 1, 0)))) ~= 4 within 1e-6
    check total(section(pipe, level(2))) ~= tau within 1e-6
    check total(section(plane_patch((0, 0), (2, 0), (0, 3)), XY)) ~= 10 within 1e-9
}

test "four branches leave a saddle" {
    let saddle = bilinear((-1, -1, 1), (-1, 1, -1), (1, -1, -1), (1, 1, 1))
    check [for c in section(saddle, XY): length(c)] ~= [1, 1, 1, 1] within 1e-6
    check [for c in intersect(saddle, plane_patch((-2, -2), (4, 0), (0, 4))): length(c)]
        ~= [1, 1, 1, 1] within 1e-6
}

test "T1: a bump between samples gives its small loop" {
    let bump = clamped([
        for i in 0..39: [for j in 0..39: (i, j, if i == 21 and j == 17 then 3 else 0)]
    ])
    let loop = section(bump, level(1.3))
    check len(loop) == 1 and loop[0].closed and length(loop[0]) < 1
    check total(intersect(bump, plane_patch((-1, -1, 1.3), (50, 0), (0, 50))))
        ~= total(loop) within 1e-5
}

// geomcore loses circles up to a radius of 0.045.
test "circles beside the pole of a spline sphere" {
    let ball = to_nurbs(
        parametric((u, v) => (cos(u)*cos(v), sin(u)*cos(v), sin(v)), 0..tau, -pi/2..pi/2),
        1e-9,
    )
    check every(
        [0.0045, 0.02, 0.045, 0.3],
        r => total(section(ball, level(sqrt(1 - r^2)))) ~= tau*r within 1e-5,
    )
}
