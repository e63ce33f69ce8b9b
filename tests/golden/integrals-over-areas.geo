// Over a region: what it measures itself, moments, and functions that are not defined outside of it.
region plate = region(polyline([(0, 0), (4, 0), (4, 2), (0, 2)], closed = true), holes = [circle((1, 1), 0.5)])
check integrate(p => 1, plate) ~= area(plate) within 1e-10
check integrate(p => p, plate) ~= area(plate) * centroid(plate) within 1e-10
check integrate(p => p.y^2, plate) ~= 4 * 2^3 / 3 - pi * 0.5^2 * (1 + 0.5^2 / 4) within 1e-10
region disc = region(circle((1, 2), 3))
check integrate(p => sqrt(9 - (p.x - 1)^2 - (p.y - 2)^2), disc) ~= 2/3 * pi * 27 within 1e-8
check integrate(p => 1 / sqrt(9 - (p.x - 1)^2 - (p.y - 2)^2), disc, tolerance = 1e-4) ~= 2 * pi * 3 within 1e-4
check integrate(p => 1m, disc) ~= 9 * pi * 1000 within 1e-6
// In another plane the points are those of space.
region upright = rotate(disc, 90deg, axis = (1, 0, 0))
check integrate(p => p.z, upright) ~= 2 * 9 * pi within 1e-9
// A cusp, a crescent, a list of parts.
region drop = region(bezier((0, 0), (3, 3), (-3, 3), (0, 0)))
check integrate(p => 1, drop) ~= area(drop) within 1e-10
regions moon = difference(region(circle((0, 0), 2)), region(circle((1, 0), 1)))
check integrate(p => p.x, moon) ~= -pi within 1e-9
check integrate(p => p.x, [plate, disc]) ~= area(plate) * centroid(plate).x + 9 * pi within 1e-9

// Over faces, over seams and poles of their surfaces, and beside surfaces.
surface ball = sphere((0, 0), 2)
face cap = trim(ball, by = plane((0, 0, 1), (0, 0, 1)), keep = "above")
check integrate(p => 1, cap) ~= 4 * pi within 1e-8
check integrate(p => p.z, cap) ~= 4 * pi * 1.5 within 1e-8
check integrate(p => sqrt(p.z - 1), cap) ~= tau * 2 * 2/3 within 1e-6
check integrate(p => p.z^2, [cap, trim(ball, by = plane((0, 0, 1), (0, 0, 1)), keep = "below")]) ~= integrate(p => p.z^2, ball) within 1e-7
face tilted = trim(ball, by = plane((0, 0.3, 0.5), (1, 2, 2)), keep = "above")
check integrate(p => p, tilted) ~= area(tilted) * centroid(tilted) within 1e-7
face hole = face(plane_patch((0, 0), (4, 0), (0, 4)), [reversed(circle((2, 2), 1))])
check integrate(p => p.x^2, hole) ~= 4 * 64 / 3 - pi * (4 + 1/4) within 1e-8
solid post = extrude(region(circle((0, 0), 1)), (0, 0, 3))
check integrate(p => p.z, post.faces) ~= tau * 4.5 + 3 * pi within 1e-8
print integrate(p => 2, plate)
// What adds up to nothing is nothing.
check integrate((x, y) => y * cos(x), [0..1, -1..1]) ~= 0 within 1e-15
let told = integrate(p => p.x^2, disc, report = true)
check abs(told.integral - 9 * pi * (1 + 9/4)) <= told.error and told.error < 1e-9
