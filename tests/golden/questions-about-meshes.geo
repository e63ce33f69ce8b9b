// The border, and how the triangles hang together, of a body with and without its lid.
surfaces faces = box((0, 0, 0), (1, 2, 3))
mesh body = tessellate(faces)
mesh pot = tessellate(faces[0..<5])
print check_mesh(body)
print check_mesh(pot)
check volume(body) ~= 6 and area(body) ~= 22
check centroid(body) ~= (0.5, 1, 1.5)
check [for c in border(pot): c.closed] == [true]
check length(border(pot)[0]) ~= 6 or length(border(pot)[0]) ~= 8 or length(border(pot)[0]) ~= 10

// A flat mesh under half of a cylinder: the top is furthest away.
surface half = trim(cylinder((0, 0, 0), 1, 4, axis = (0, 1, 0)), u = 0..0.5)
mesh coarse = grid_mesh(half, 2, 1)
let far = deviation(coarse, half)
check far.max ~= 1 - sqrt(0.5) within 1e-9
// The middle of a chord is one minus the root of a half away, and the corners nothing.
check far.mean ~= 2/3*(1 - sqrt(0.5)) within 0.05
