// Vukašinović, Duhovnik: Interior knot multiplicity 1 (Sec 1.3.2, Fig 1.18 T1)
geo 1
curve c = bspline([(0, 0), (1, 3), (3, 4), (4, 1), (6, 0), (7, 3), (9, 2)], degree = 3, knots = [0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4])
check len(c.points) == 7
check continuity(trim(c, 0..2), trim(c, 2..4)).c == 2
check c(0) ~= (0, 0, 0) within 1e-12
check c(0.5) ~= (35/24, 91/32, 0) within 2.84e-12
check c(2) ~= (25/6, 4/3, 0) within 4.17e-12
check c(2.5) ~= (481/96, 21/32, 0) within 5.01e-12
check c(4) ~= (9, 2, 0) within 9e-12
