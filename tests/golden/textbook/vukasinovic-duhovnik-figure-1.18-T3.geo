// Vukašinović, Duhovnik: Interior knot multiplicity 3 (Sec 1.3.2, Fig 1.18 T3)
geo 1
curve c = bspline([(0, 0), (1, 3), (3, 4), (4, 1), (6, 0), (7, 3), (9, 2), (10, 1), (11, 4)], degree = 3, knots = [0, 0, 0, 0, 1, 2, 2, 2, 3, 4, 4, 4, 4])
check len(c.points) == 9
check continuity(trim(c, 0..2), trim(c, 2..4)).c == 0
check c(0) ~= (0, 0, 0) within 1e-12
check c(0.5) ~= (47/32, 45/16, 0) within 2.81e-12
check c(2) ~= (6, 0, 0) within 6e-12
check c(2.5) ~= (239/32, 37/16, 0) within 7.47e-12
check c(4) ~= (11, 4, 0) within 1.1e-11
