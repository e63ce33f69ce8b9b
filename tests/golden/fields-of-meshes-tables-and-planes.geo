mesh m = grid_mesh(bilinear((0, 0), (0, 1), (1, 0), (1, 1)), 1, 1)
print m.vertices, m.triangles, m.normals, m.uvs
table t = table({name: ["a", "b"], size: [1, 2.5]})
print t.name, t[1], t[-1].size, len(t)
check t[0] == {name: "a", size: 1}
print XY.origin, XY.x, XY.y, XY.z
check YZ.z == (1, 0, 0) and ZX.z == (0, 1, 0)
