curve c = bspline((0, 0), (1, 2), (2, 2), (3, 0), (4, 1), degree = 2, knots = [0, 0, 0, 1, 1, 1, 1, 2])
