// Linkeová, Exercise 2.26 a): a clamped cubic as C2 Bézier cubics.
curve c = clamped([(1, 1), (3, 1), (5, 7), (7, 1), (9, 4)])
check len(decompose(c)) == 2
check [for piece in decompose(c): piece.points] ~= [[(1, 1, 0), (3, 1, 0), (4, 4, 0), (5, 4, 0)], [(5, 4, 0), (6, 4, 0), (7, 1, 0), (9, 4, 0)]] within 9e-11
check derivative(trim(c, 0..1), 1) ~= (3, 0, 0) within 3e-11
check derivative(trim(c, 1..2), 1) ~= (3, 0, 0) within 3e-11
check join(decompose(c)).points ~= c.points
