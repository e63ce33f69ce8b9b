curve c = nurbs([(0, 0), (1, 1), (2, 0)], degree = 3)
