// Linkeová: Open Coons cubic B-spline (Example 2.13 a), Fig 2.22)
geo 1
curve c = coons_bspline([(0, 0), (-6, 6), (-6, 0), (0, -6), (6, 0), (6, 6), (0, 0)])
let pieces = decompose(c)
check len(decompose(c)) == 4
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
check [for piece in decompose(c): piece.points] ~= [
  [(-5, 4, 0), (-6, 4, 0), (-6, 2, 0), (-5, 0, 0)],
  [(-5, 0, 0), (-4, -2, 0), (-2, -4, 0), (0, -4, 0)],
  [(0, -4, 0), (2, -4, 0), (4, -2, 0), (5, 0, 0)],
  [(5, 0, 0), (6, 2, 0), (6, 4, 0), (5, 4, 0)],
] within 6e-12
check continuity(pieces[0], pieces[1]).c == 2
check continuity(pieces[1], pieces[2]).c == 2
check continuity(pieces[2], pieces[3]).c == 2
check not is_closed(c)
check c.knots ~= [-3, -2, -1, 0, 1, 2, 3, 4, 5, 6, 7] within 7e-12
check to_clamped(c).points ~= [(-5, 4, 0), (-6, 4, 0), (-6, 0, 0), (0, -6, 0), (6, 0, 0), (6, 4, 0), (5, 4, 0)] within 6e-12
check to_clamped(c).knots ~= [0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4] within 4e-12
