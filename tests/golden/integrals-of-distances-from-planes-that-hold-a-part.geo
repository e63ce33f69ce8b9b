// On an edge or a face in the plane from which a distance is measured it is rounding: its square there counts nothing
// beside what it is on the others.
let about = (1, 2, 3)
let across = rotate((1, 0, 0), 33deg, axis = about)
fn turned(g) = rotate(g, 33deg, axis = about)
curve angle = polyline([(0, 0), (0, 1), (1, 1)])
check integrate(p => dot(p, across)^2, turned(angle)) ~= 1/3 within 1e-12
check integrate(p => (p.x - 10.1)^2, translate(angle, (10.1, 0))) ~= 1/3 within 1e-12
check integrate(p => (p.x - 10.1)^2, [line((10.1, 0), (10.1, 1)), line((10.1, 1), (11.1, 1))]) ~= 1/3 within 1e-12
// Of the faces of a cube one is as far as 1 all over, and four go up to there.
surfaces cube = [for side in box((0, 0, 0), (1, 1, 1)): turned(side)]
check integrate(p => dot(p, across)^2, cube) ~= 1 + 4/3 within 1e-11
check integrate(p => dot(p, across)^2, solid(cube).faces) ~= 1 + 4/3 within 1e-11
check integrate(p => dot(p, across), cube) ~= 1 + 4/2 within 1e-11

// Far from zero, and on lines of a surface that lie in the plane.
check integrate(p => (p.x - 10)^2, sphere((10, 0), 1)) ~= 4*pi/3 within 1e-11
check integrate(p => (p.x - 100)^2, sphere((100, 0), 1)) ~= 4*pi/3 within 1e-11
check integrate(p => (p.y + 30)^2, cylinder((5, -30), 2, 3)) ~= 3 * pi * 2^3 within 1e-10
check integrate(p => (p.x - 50)^2, torus((50, 0), 3, 1)) ~= 2*pi^2 * 3 * (3^2 + 3/2) within 1e-8
let by_radius = gradient(r => integrate(p => (p.x - 10)^2, sphere((10, 0), r)), 1)
check by_radius ~= 16*pi/3 within 1e-9
check integrate((x, y) => (x + 100*y - 100*y)^2, [-1..1, 0..2]) ~= 4/3 within 1e-11

// Grows without bound halfway, where nothing asks.
region square = region(polyline([(-1, -1), (1, -1), (1, 1), (-1, 1)], closed = true))
check integrate(p => ln(abs(p.x)), square) ~= -4 within 1e-9
check integrate(p => abs(p.y)^-0.5, square, tolerance = 1e-6) ~= 8 within 1e-6
check integrate((x, y) => ln(abs(x)), [-1..1, 0..1], tolerance = 1e-6) ~= -2 within 1e-6
check integrate(p => abs(p.x)^-0.5, region(circle((0, 0), 1)), tolerance = 1e-6) ~= 6.992153478112 within 1e-6
