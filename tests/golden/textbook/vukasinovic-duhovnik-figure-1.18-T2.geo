// Vukašinović, Duhovnik: Interior knot multiplicity 2 (Sec 1.3.2, Fig 1.18 T2)
geo 1
curve c = bspline([(0, 0), (1, 3), (3, 4), (4, 1), (6, 0), (7, 3), (9, 2), (10, 1)], degree = 3, knots = [0, 0, 0, 0, 1, 2, 2, 3, 4, 4, 4, 4])
check len(c.points) == 8
check continuity(trim(c, 0..2), trim(c, 2..4)).c == 1
check c(0) ~= (0, 0, 0) within 1e-12
check c(0.5) ~= (47/32, 45/16, 0) within 2.81e-12
check c(2) ~= (5, 1/2, 0) within 5e-12
check c(2.5) ~= (199/32, 7/8, 0) within 6.22e-12
check c(4) ~= (10, 1, 0) within 1e-11
