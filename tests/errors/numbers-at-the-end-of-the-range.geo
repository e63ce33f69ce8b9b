curve c = bspline((0, 0), (1, 1), (2, 0), degree = 1, knots = [-1e308, -1e308, 0, 1e308, 1e308])
surface s = sphere((0, 0), 1e-300)
print volume(sphere((0, 0), 1e150))
