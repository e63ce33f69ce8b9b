// A plane or a solid that only touches a face leaves all of it, or nothing; a line from border to border divides it.
geo 1

fn areas(parts) = sort([for part in parts: area(part) / 1mm^2])

// In a point.
let ball = sphere((0, 0), 1)
let tip = plane((0, 0, 1), (0, 0, 1))
face under = trim(ball, by = tip, keep = "below")
check area(under) ~= 4 * pi within 1e-9
check trim(ball, by = tip, keep = "above") == none
let plate = plane_patch((-3, -3), (6, 0), (0, 6))
face beside = trim(plate, by = solid(sphere((0, 0, 1), 1)), keep = "outside")
check area(beside) ~= 36 within 1e-9

// Along a line that ends inside, of a cylinder, a cone, and a freeform sheet that is bent one way.
let roller = cylinder((-1, 0, 1), 1, 2, axis = (1, 0, 0))
face below = trim(plate, by = solid(roller, cap = true), keep = "outside")
check area(below) ~= 36 within 1e-9
check trim(plate, by = solid(roller, cap = true), keep = "inside") == none

// Along a line from border to border: a seam, and a line beside it.
let tube = cylinder((0, 0), 1, 2)
fn tangent(angle) = plane(polar(1, angle), polar(1, angle))
check every([0deg, 37deg, 90deg], angle => abs(area(trim(tube, by = tangent(angle), keep = "below")) / 1mm^2 - 4 * pi) < 1e-9)
face half = trim(tube, by = plane((0, 0), (0, 1, 0)), keep = "above")
face all = trim(half, by = tangent(90deg), keep = "below")
check area(all) ~= 2 * pi within 1e-9
check areas(split(half, by = tangent(90deg))) ~= [pi, pi] within 1e-9

// Around: the ring under a torus.
let ring = torus((0, 0, 1), 2, 1)
face around = trim(plate, by = solid(ring), keep = "outside")
check area(around) ~= 36 within 1e-9
check areas(split(plate, by = ring)) ~= [4 * pi, 36 - 4 * pi] within 1e-9

// A cylinder inside of a ball, whose rims lie on that.
let inscribed = solid(cylinder((0, 0, -0.8), 0.6, 1.6), cap = true)
face outside = trim(ball, by = inscribed, keep = "outside")
check area(outside) ~= 4 * pi within 1e-9
