// Linkeová: Closed Coons cubic B-spline (P7=P1, P8=P2 appended) (Example 2.13 b), Fig 2.23)
geo 1
curve c = coons_bspline([(0, 0), (-6, 6), (-6, 0), (0, -6), (6, 0), (6, 6), (0, 0), (-6, 6), (-6, 0)])
let pieces = decompose(c)
check len(decompose(c)) == 6
check c(0) ~= (-5, 4, 0) within 5e-12
check derivative(c, 0) ~= (-3, 0, 0) within 3e-12
check c(1) ~= (-5, 0, 0) within 5e-12
check derivative(c, 1) ~= (3, -6, 0) within 6e-12
check c(2) ~= (0, -4, 0) within 4e-12
check derivative(c, 2) ~= (6, 0, 0) within 6e-12
check c(3) ~= (5, 0, 0) within 5e-12
check derivative(c, 3) ~= (3, 6, 0) within 6e-12
check c(4) ~= (5, 4, 0) within 5e-12
check derivative(c, 4) ~= (-3, 0, 0) within 3e-12
check c(5) ~= (0, 2, 0) within 2e-12
check derivative(c, 5) ~= (-6, 0, 0) within 6e-12
check c(6) ~= (-5, 4, 0) within 5e-12
check derivative(c, 6) ~= (-3, 0, 0) within 3e-12
check [for piece in decompose(c): piece.points] ~= [
  [(-5, 4, 0), (-6, 4, 0), (-6, 2, 0), (-5, 0, 0)],
  [(-5, 0, 0), (-4, -2, 0), (-2, -4, 0), (0, -4, 0)],
  [(0, -4, 0), (2, -4, 0), (4, -2, 0), (5, 0, 0)],
  [(5, 0, 0), (6, 2, 0), (6, 4, 0), (5, 4, 0)],
  [(5, 4, 0), (4, 4, 0), (2, 2, 0), (0, 2, 0)],
  [(0, 2, 0), (-2, 2, 0), (-4, 4, 0), (-5, 4, 0)],
] within 6e-12
check continuity(pieces[0], pieces[1]).c == 2
check continuity(pieces[1], pieces[2]).c == 2
check continuity(pieces[2], pieces[3]).c == 2
check continuity(pieces[3], pieces[4]).c == 2
check continuity(pieces[4], pieces[5]).c == 2
check is_closed(c)
check continuity(pieces[5], pieces[0]).c == 2
check c.knots ~= [-3, -2, -1, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9] within 9e-12
check to_clamped(c).points ~= [(-5, 4, 0), (-6, 4, 0), (-6, 0, 0), (0, -6, 0), (6, 0, 0), (6, 6, 0), (0, 0, 0), (-4, 4, 0), (-5, 4, 0)] within 6e-12
check to_clamped(c).knots ~= [0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 6, 6, 6] within 6e-12
