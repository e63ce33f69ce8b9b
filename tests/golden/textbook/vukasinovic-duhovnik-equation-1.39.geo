// Vukašinović, Duhovnik: Ruled surface between a quadratic and a cubic ((1.38)-(1.39))
geo 1
curve rail0 = bezier((0, 0, 0), (1, 0, 2), (3, 0, 0))
curve rail1 = bezier((0, 2, 1), (1, 3, 0), (2, 2, 2), (3, 2, 1))
surface s = ruled(rail0, rail1)
check s(1/3, 0) ~= (7/9, 0, 8/9) within 1e-12
check s(1/3, 1) ~= (1, 22/9, 7/9) within 2.44e-12
check s(1/3, 1/4) ~= (5/6, 11/18, 31/36) within 1e-12
check s(3/4, 1/2) ~= (69/32, 137/128, 65/64) within 2.16e-12
check [s.degree_u, s.degree_v] == [3, 1]
