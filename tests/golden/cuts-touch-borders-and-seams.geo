// Cuts that touch a border in one point, a seam, or the place where both seams of a torus cross.
geo 1

fn areas(parts) = sort([for part in parts: area(part) / 1mm^2])
let square = plane_patch((0, 0), (4, 0), (0, 4))
check areas(split(square, by = circle((2, 1, 0), 1))) ~= [pi, 16 - pi] within 1e-9
check areas(split(square, by = [circle((1, 2, 0), 1), circle((0.5, 2, 0), 0.5)])) ~= [pi / 4, 0.75 * pi, 16 - pi] within 1e-9
let lid = split(disc((0, 0, 0), 2), by = circle(polar(1.5, 30deg), 0.5))
check areas(lid) ~= [pi / 4, 3.75 * pi] within 1e-9

let ball = sphere((0, 0, 0), 2)
let cap = 4 * pi * (2 - sqrt(2))
check areas(split(ball, by = plane((2, 0, 0), (1, 1, 0)))) ~= [cap, 16 * pi - cap] within 1e-9
face rest = trim(ball, by = plane((2, 0, 0), (1, 1, 0)), keep = (-2, 0, 0))
check area(rest) ~= 16 * pi - cap within 1e-9

solid ring = solid(torus((0, 0, 0), 3, 1))
check volume(cut(ring, plane((0, 0, 0), (0, 1, 1)))) ~= 3 * pi^2 within 1e-6
check volume(cut(ring, plane((4, 0, 0), (1, 0.3, 0.2)))) + volume(cut(ring, plane((4, 0, 0), (1, 0.3, 0.2)), keep = "above")) ~= 6 * pi^2 within 1e-6

// A thin tube through a ball.
face inside = trim(cylinder((0, 0, -12), 0.1, 24), by = sphere((0, 0, 0), 10), keep = (0.1, 0, 0))
check area(inside) ~= 0.4 * pi * sqrt(99.99) within 1e-9

// A plane that touches a hole, or a seam: each side is judged by itself, and a section needs none.
face below = trim(ball, by = plane((2, 0, 0), (1, 1, 0)), keep = "below")
check area(below) ~= 16 * pi - cap within 1e-9
let depth = 2 - sqrt(2)
check volume(cut(solid(ball), plane((2, 0, 0), (1, 1, 0)), keep = "above")) ~= pi * depth^2 * (6 - depth) / 3 within 1e-6
let holes = [circle((1, 1), 0.5), circle((3, 1), 0.5)]
solid plate = extrude(region(polyline([(0, 0), (4, 0), (4, 2), (0, 2)], closed = true), holes = holes), (0, 0, 1))
let beside = plane((1.5, 0, 0), (1, 0, 0))
check volume(cut(plate, beside, keep = "above")) ~= 5 - pi / 4 within 1e-6
check sum([for part in section(plate, beside): area(part)]) ~= 2 within 1e-6
