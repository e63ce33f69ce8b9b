unit mm
// A boss that stands on a plate covers its disc, also where it is sunk or lifted within the tolerance.
surface plate = plane_patch((-2, -2), (4, 0), (0, 4))
fn boss(z) = solid(cylinder((0, 0, z), 1, 2), cap = true)
let heights = [0, 1e-9, -1e-9, 5e-7, -5e-7]
check every([for z in heights: area(trim(plate, by = boss(z), keep = "inside")) ~= pi])
check every([for z in heights: area(trim(plate, by = boss(z), keep = "outside")) ~= 16 - pi])
// Beyond it the one goes through the plate, the other is apart.
check area(trim(plate, by = boss(-1e-4), keep = "inside")) ~= pi
print trim(plate, by = boss(1e-4), keep = "inside")
// Of the wall and the top of the boss and what is left of the plate a skin is made: the base lies on the plate.
faces skin = [for f in faces(boss(0)) if trim(f, by = solid(box((-2, -2, -1), (4, 4, 1))), keep = "outside") != none: f]
check len(skin) == 2
// Walls flush with a side of the plate, over its corner, and turned.
check area(trim(plate, by = solid(box((-1, -2), (1, 2, 1))), keep = "inside")) ~= 2
check area(trim(plate, by = solid(box((1, 1), (3, 3, 1))), keep = "outside")) ~= 15
check area(trim(rotate(plate, 30deg, axis = (1, 2, 3)), by = rotate(solid(box((-1, -1), (1, 2, 1))), 30deg, axis = (1, 2, 3)), keep = "inside")) ~= 2
// By faces in its plane, whichever way they look.
check [for f in split(plate, by = plane_patch((-1, -1), (0, 1), (5, 0))): area(f)] ~= [13, 3]
check area(trim(plate, by = face(region(circle((2, 0), 1))), keep = (1.5, 0))) ~= pi/2
check area(trim(disc((0, 0), 1), by = plane_patch((0, -2), (4, 0), (0, 4)), keep = (-0.5, 0))) ~= pi/2
// Shafts in bores of the same radius, whole and a quarter of one, and cones.
surface bore = cylinder((0, 0), 1, 4)
solid shaft = solid(cylinder((0, 0, 3), 1, 2, axis = (0, 0, -1)), cap = true)
check [for f in trim(bore, by = shaft, keep = "outside"): area(f)] ~= [2*pi, 2*pi]
check area(trim(bore, by = shaft, keep = "inside")) ~= 4*pi
solid quarter = extrude(region(join([arc((0, 0, 1), 1, 20deg, 110deg), polyline(arc((0, 0, 1), 1, 20deg, 110deg).end, (0, 0, 1), arc((0, 0, 1), 1, 20deg, 110deg).start)])), (0, 0, 2))
check area(trim(bore, by = quarter, keep = "inside")) ~= pi
check area(trim(bore, by = quarter, keep = "outside")) ~= 7*pi
check area(trim(cone((0, 0), 2, 0, 4), by = cone((0, 0, 1), 1.5, 0.5, 2), keep = (1, 0, 2))) ~= 4*pi*sqrt(1.25)
// Caps of one sphere whose poles are elsewhere, and parts of one spline.
surface ball = sphere((0, 0), 1)
solid half = cut(solid(rotate(ball, 70deg, axis = (1, 1, 0))), plane((0, 0), (1, 0, 1)), keep = "above")
check area(trim(ball, by = half, keep = "inside")) ~= 2*pi
print trim(ball, by = solid(ball), keep = "outside")
surface saddle = bilinear((0, 0), (0, 1), (1, 0), (1, 1, 1))
face strip = trim(saddle, by = plane((0.5, 0), (1, 0, 0)), keep = "above")
check sum([for f in split(saddle, by = strip): area(f)]) ~= area(saddle) and len(split(saddle, by = strip)) == 2
// Volumes are known as well as edges are near one another.
check volume(half, accuracy = 1e-9) ~= 2/3*pi within 1e-9
check volume(boss(0), accuracy = 1e-9) ~= 2*pi within 1e-9
