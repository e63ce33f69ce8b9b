// Linkeová: Data structure dump of the clamped curve Fig 2.26 d) (Sec 2.5.3 List of data structure)
geo 1
curve c = clamped([(4, 5), (3, 7), (1, 7), (4, 1), (7, 7), (10, 1), (8, 1), (7, 3)])
check c.degree + 1 == 4
check len(c.points) == 8
check c.points ~= [(4, 5, 0), (3, 7, 0), (1, 7, 0), (4, 1, 0), (7, 7, 0), (10, 1, 0), (8, 1, 0), (7, 3, 0)] within 1e-11
check c.knots ~= [0, 0, 0, 0, 1, 2, 3, 4, 5, 5, 5, 5] within 5e-12
