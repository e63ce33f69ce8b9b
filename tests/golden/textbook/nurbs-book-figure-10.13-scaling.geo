// The NURBS Book: Piecewise linear scaling function of a sweep (Fig 10.13)
geo 1
curve c = bspline([(0.3, 0.3, 1), (1.5, 1.5, 0.5), (0.3, 0.3, 1), (1, 1, 2)], degree = 1, knots = [0, 0, 3/10, 7/10, 1, 1])
check c(0) ~= (3/10, 3/10, 1) within 1e-12
check c(0.15) ~= (9/10, 9/10, 3/4) within 1e-12
check c(0.3) ~= (3/2, 3/2, 1/2) within 1.5e-12
check c(0.5) ~= (9/10, 9/10, 3/4) within 1e-12
check c(0.7) ~= (3/10, 3/10, 1) within 1e-12
check c(0.85) ~= (13/20, 13/20, 3/2) within 1.5e-12
check c(1) ~= (1, 1, 2) within 2e-12
