curve c = clamped((1, 1), (3, 1), (5, 7), (7, 1), (9, 4))
curve d = hodograph(c)
check d.degree == 2
check d.knots == [0, 0, 0, 1, 2, 2, 2]
check [for t in linspace(0, 2, 9): d(t)] ~= [for t in linspace(0, 2, 9): derivative(c, t)] within 1e-13

// Of a rational curve it is rational of twice the degree.
curve round = circle((1, 2), 3)
curve speed = hodograph(round)
check speed.degree == 4
check [for t in linspace(0, 1, 17): speed(t)] ~= [for t in linspace(0, 1, 17): derivative(round, t)] within 1e-12

// Of a periodic curve it is periodic, and at a corner it jumps.
check hodograph(coons_bspline((0, 0), (6, 0), (6, 6), (0, 6), closed = true)).closed
curve turn = hodograph(polyline((0, 0), (1, 0), (1, 2)))
check turn.points == [(1, 0), (0, 2)]
check turn(0.999) == (1, 0)
check turn(1) == (0, 2)
