curve a = bspline((0, 0), (1, 0), (1, 1), degree = 5)
curve b = clamped((0, 0), (1, 0), (1, 1), degree = 0)
curve c = bspline((0, 0), (1, 0), (1, 1), degree = 0, closed = true)
