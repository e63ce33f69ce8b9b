// Vukašinović, Duhovnik: Triple interior knot: curve passes through P_3 with C0 (Sec 1.3.2 {0,0,0,0,0.2,0.2,0.2,0.8,1,1,1,1})
geo 1
curve c = bspline([(0, 0), (1, 3), (3, 4), (4, 1), (6, 0), (7, 3), (9, 2), (10, 1)], degree = 3, knots = [0, 0, 0, 0, 0.2, 0.2, 0.2, 0.8, 1, 1, 1, 1])
check c(0.2) ~= (4, 1, 0) within 4e-12
check c(0.2) ~= c.points[3] within 1e-11
check continuity(trim(c, 0..0.2), trim(c, 0.2..1)).c == 0
check [for i in 0..7: bspline([for j in 0..7: (if i == j then 1 else 0, j)], degree = 3, knots = [0, 0, 0, 0, 0.2, 0.2, 0.2, 0.8, 1, 1, 1, 1])(0.2).x] ~= [0, 0, 0, 1, 0, 0, 0, 0] within 1e-12
check c(0.1) ~= (2, 11/4, 0) within 2.75e-12
check derivative(c, 0.1) ~= (45/2, 15/2, 0) within 2.25e-11
check c(0.5) ~= (805/128, 5/4, 0) within 6.29e-12
check derivative(c, 0.5) ~= (385/64, 35/8, 0) within 6.02e-12
check c(0.9) ~= (1129/128, 2, 0) within 8.82e-12
check derivative(c, 0.9) ~= (585/64, -45/8, 0) within 9.14e-12
