// How faces go on in one another along the edges that they share, corners and all, told alike in both orders.
geo 1

fn both(a, b) = [continuity(a, b), continuity(b, a)]
fn orders(a, b) = [for c in both(a, b): c.g]

face square = face(plane_patch((0, 0), (1, 0), (0, 1)))
check orders(square, face(plane_patch((1, 0), (1, 0), (0, 1)))) == [2, 2]
check [for c in both(square, face(plane_patch((1, 0), (1, 0, 0.1), (0, 1)))): c.angle]
    ~= [atan(0.1), atan(0.1)] within 1e-9rad
check [for c in both(square, face(plane_patch((1, 0.25), (1, 0), (0, 0.5)))): c.g] == [2, 2]
// An edge that is short beside those of the other.
check [for c in both(square, face(plane_patch((1, 0.501), (0, 0, 1), (0, 0.005)))): c.angle]
    ~= [90deg, 90deg] within 1e-9rad

// Parts of one surface go on as it does.
let halves = split(cylinder((0, 0), 1, 3), by = YZ)
check orders(halves[0], halves[1]) == [2, 2]
surface wave = bspline([for i in 0..4: [for j in 0..4: (i, j, sin(i) * cos(j))]], degree = 3)
let parts = split(wave, by = plane((2, 2), (1, 0.3, 0)))
check orders(parts[0], parts[1]) == [2, 2]

// A half ball on half a cylinder: one tangent plane, another bend.
face cup = trim(trim(sphere((0, 0), 1), by = XY, keep = "below"), by = YZ, keep = "above")
face wall = trim(cylinder((0, 0), 1, 2), by = YZ, keep = "above")
check orders(cup, wall) == [1, 1]
check [for c in both(cup, wall): c.curvature_gap] ~= [1mm^-1, 1mm^-1] within 1e-6mm^-1
