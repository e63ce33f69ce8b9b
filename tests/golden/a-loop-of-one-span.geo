// A closed curve without knots between its ends: it begins and ends in one place, and bounds what it goes around.
geo 1

let patch = plane_patch((0, 0), (4, 0), (0, 4))
let loop = bezier((1, 1), (5, 1), (-1, 3), (3, 3), (1, 1))
check area(face(patch, [loop])) ~= area(region(loop)) within 1e-12
check area(split(patch, by = loop)[0]) + area(split(patch, by = loop)[1]) ~= 16mm^2 within 1e-12
