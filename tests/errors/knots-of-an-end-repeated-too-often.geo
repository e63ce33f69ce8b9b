curve c = nurbs((0, 0), (1, 2), (2, 2), (3, 0), degree = 3, knots = [0, 0, 0, 0, 0, 1, 1, 1])
curve d = nurbs((0, 0), (1, 2), (2, 2), (3, 0), degree = 3, knots = [0, 0, 0, 1, 1, 2, 3, 3])
