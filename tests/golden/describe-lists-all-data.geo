print describe(clamped([(4, 5), (3, 7), (1, 7), (4, 1), (7, 7), (10, 1), (8, 1), (7, 3)]))
print describe(circle((0, 0), 1)).weights
print describe(bilinear((0, 0), (0, 1), (1, 0), (1, 1)))
print describe(grid_mesh(bilinear((0, 0), (0, 1), (1, 0), (1, 1)), 1, 1))
print describe(table({kind: [1, 2], name: ["a", "b"]}))
print describe([XY, (1, 2, 3), []])
