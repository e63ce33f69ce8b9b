// A conic section is exact: the weight of the middle point tells ellipse, parabola and hyperbola apart.
curve quarter = conic((2, 0), (2, 2), (0, 2), sqrt(2) / 2)
check every(sample(quarter, 21), p => norm(p) ~= 2 within 1e-15) "a quarter of a circle"

curve parabola = conic((0, 0), (1, 2), (2, 0), 1)
check sample(parabola, 9) ~= sample(bezier((0, 0), (1, 2), (2, 0)), 9) within 1e-15

// x*y = 1 from (1/2, 2) to (2, 1/2): the tangents meet at (4/5, 4/5), and the weight is 5/4.
curve hyperbola = conic((1/2, 2), (4/5, 4/5), (2, 1/2), 5/4)
check every(sample(hyperbola, 21), p => p.x * p.y ~= 1 within 1e-15)

curve straight = conic((0, 0), (1, 5), (2, 0), 0)
check every(sample(straight, 9), p => p.y == 0) "a weight of zero takes its point away"
print quarter
