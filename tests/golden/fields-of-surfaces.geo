surface s = nurbs([[(0, 0), (0, 1), (0, 2)], [(1, 0), (1, 1, 1), (1, 2)]], degree = {u: 1, v: 2}, weights = [[1, 1, 1], [1, 2, 1]])
print s.domain_u, s.domain_v, s.degree_u, s.degree_v, s.knots_u, s.knots_v
print s.weights, s.points, s.closed_u, s.closed_v, s.rational, s.patches
check s(0, 0) == (0, 0) and s(1, 1) == (1, 2)
check s(0.5, 0.5).z > 0
