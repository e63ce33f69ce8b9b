// Linkeová: Coons cubic B-spline (Exercise 2.19)
geo 1
curve c = coons_bspline([(0, -6), (-6, 0), (-6, 6), (6, 6), (6, 0), (12, 0)])
let pieces = decompose(c)
check len(decompose(c)) == 3
check c(0) ~= (-5, 0, 0) within 5e-12
check derivative(c, 0) ~= (-3, 6, 0) within 6e-12
check c(1) ~= (-4, 5, 0) within 5e-12
check derivative(c, 1) ~= (6, 3, 0) within 6e-12
check c(2) ~= (4, 5, 0) within 5e-12
check derivative(c, 2) ~= (6, -3, 0) within 6e-12
check c(3) ~= (7, 1, 0) within 7e-12
check derivative(c, 3) ~= (3, -3, 0) within 3e-12
check [for piece in decompose(c): piece.points] ~= [
  [(-5, 0, 0), (-6, 2, 0), (-6, 4, 0), (-4, 5, 0)],
  [(-4, 5, 0), (-2, 6, 0), (2, 6, 0), (4, 5, 0)],
  [(4, 5, 0), (6, 4, 0), (6, 2, 0), (7, 1, 0)],
] within 7e-12
check continuity(pieces[0], pieces[1]).c == 2
check continuity(pieces[1], pieces[2]).c == 2
check not is_closed(c)
check c.knots ~= [-3, -2, -1, 0, 1, 2, 3, 4, 5, 6] within 6e-12
check to_clamped(c).points ~= [(-5, 0, 0), (-6, 2, 0), (-6, 6, 0), (6, 6, 0), (6, 2, 0), (7, 1, 0)] within 7e-12
check to_clamped(c).knots ~= [0, 0, 0, 0, 1, 2, 3, 3, 3, 3] within 3e-12
