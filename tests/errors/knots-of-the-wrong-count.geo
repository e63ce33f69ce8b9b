curve c = nurbs([(0, 0), (1, 1), (2, 0), (3, 0)], degree = 2, knots = [0, 0, 0, 1, 1, 1])
