curve c = circle((0, 0), 2, (0, 0, 1))
curve d = bspline([(0, 0), (1, 1), (2, 0)], 2)
