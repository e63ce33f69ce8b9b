curve c = nurbs([(0, 0), (1, 1), (2, 0)], degree = 2, weights = [1, -1, 1])
curve d = bezier([(0, 0), (1, 1), (2, 0)], weights = [0, 1, 1])
