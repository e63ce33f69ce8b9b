// Hsu: C2 cubic spline through N points with given end tangents (unit intervals) (Sec 3.3 last paragraph)
geo 1
curve c = cubic_spline([(0, 0), (1, 2), (3, 3), (4, 1), (6, 0)], [(1, 1), (2, -1)])
check [for t in 0..4: derivative(c, t)] ~= [(1, 1, 0), (13/8, 31/14, 0), (3/2, -6/7, 0), (11/8, -25/14, 0), (2, -1, 0)] within 2.21e-12
check c(1/2) ~= (27/64, 95/112, 0) within 1e-12
check c(3/2) ~= (129/64, 323/112, 0) within 2.88e-12
check c(5/2) ~= (225/64, 237/112, 0) within 3.52e-12
check c(7/2) ~= (315/64, 45/112, 0) within 4.92e-12
