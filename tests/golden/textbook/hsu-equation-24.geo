// Hsu: C2 blending of two Hermite segments ((23)-(24))
geo 1
curve c = cubic_spline([(0, 0, 0), (2, 3, 1), (5, 1, 2)], [(1, 2, 0), (3, 0, -1)])
check derivative(c, 1) ~= (11/4, 1/4, 7/4) within 2.75e-12
check derivative(trim(c, 0..1), 1, order = 2) ~= (1, -13, 1) within 1.3e-11
check derivative(trim(c, 1..2), 1, order = 2) ~= (1, -13, 1) within 1.3e-11
check continuity(trim(c, 0..1), trim(c, 1..2)).c >= 2
check c(1/2) ~= (25/32, 55/32, 9/32) within 1.72e-12
check c(4/3) ~= (80/27, 68/27, 43/27) within 2.96e-12
