// Vukašinović, Duhovnik: a weight of zero takes its point away ((1.20)-(1.22), Fig 1.20)
geo 1
let ctrl = [(0, 0), (1, 3), (3, 4), (4, 1), (6, 0), (7, 3), (9, 2)]
let knot_vector = [0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4]
curve c = nurbs(ctrl, weights = [1, 1, 1, 0, 1, 1, 1], knots = knot_vector)
check basis(c, 2) ~= [0, 0, 1/2, 0, 1/2, 0, 0] within 1e-12
check c(2) ~= (9/2, 2, 0) within 4.5e-12
curve straight = bezier([(0, 0), (1, 1), (2, 0)], weights = [1, 0, 1])
check straight(1/2) ~= (1, 0, 0) within 1e-12
