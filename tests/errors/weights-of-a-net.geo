let net = [for i in 0..2: [for j in 0..2: (i, j)]]
surface negative = nurbs(net, degree = 2, weights = [[1, 1, 1], [1, 1, -2], [1, 1, 1]])
surface ragged = nurbs(net, degree = 2, weights = [[1, 1, 1], [1], [1, 1, 1]])
surface too_few = nurbs(net, degree = 2, weights = [[1, 1], [1, 1]])
surface vanishing = nurbs(net, degree = 2, weights = [[0, 0, 0], [0, 0, 0], [0, 0, 0]])
surface no_points = interpolate([[], []])
surface one_row = interpolate([[(0, 0), (1, 0)]])
