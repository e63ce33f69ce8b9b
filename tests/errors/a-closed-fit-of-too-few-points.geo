curve a = interpolate([(0, 0), (1, 1), (0, 0)], closed = true)
curve b = interpolate([(0, 0)], closed = true)
curve c = lagrange([(0, 0)])
