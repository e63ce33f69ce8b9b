let faces = box((0, 0, 0), (1, 2, 3))
let turned = [for i in 0..5: if i % 3 == 0 then faces[i] else flip(faces[i])]
let middle = (0.5, 1, 1.5)
fn outward(s) = dot(normal(s, 0.5, 0.5), s(0.5, 0.5) - middle) > 0

// A closed list faces outward, whichever of its surfaces were turned.
check every(orient(turned), outward)
check every(orient([for f in faces: flip(f)]), outward)
check every(orient(faces), outward)
check not every(turned, outward)
check check_mesh(tessellate(orient(turned))).oriented
check volume(tessellate(orient(turned))) ~= 6

// An open one faces as its first surface; parts that do not touch are taken one by one.
let floor = plane_patch((0, 0), (1, 0), (0, 1))
let wall = plane_patch((1, 0), (0, 0, 1), (0, 1))
check normal(orient([floor, wall])[1], 0.5, 0.5) ~= (-1, 0, 0)
check normal(orient([flip(floor), wall])[1], 0.5, 0.5) ~= (1, 0, 0)
let far = translate(flip(floor), (5, 0))
check normal(orient([floor, far])[1], 0.5, 0.5) ~= (0, 0, -1)
