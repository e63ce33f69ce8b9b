// Linkeová: Clamped curve identical with the open Coons B-spline of Example 2.13 (Sec 2.5, (2.53), Fig 2.25)
geo 1
curve c = coons_bspline([(0, 0), (-6, 6), (-6, 0), (0, -6), (6, 0), (6, 6), (0, 0)])
check to_clamped(c).points ~= [(-5, 4, 0), (-6, 4, 0), (-6, 0, 0), (0, -6, 0), (6, 0, 0), (6, 4, 0), (5, 4, 0)] within 6e-12
check to_clamped(c).knots ~= [0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4] within 4e-12
check c(0) ~= (-5, 4, 0) within 5e-12
check c(0.5) ~= (-23/4, 11/4, 0) within 5.75e-12
check c(1) ~= (-5, 0, 0) within 5e-12
check c(7/3) ~= (53/27, -92/27, 0) within 3.41e-12
check c(4) ~= (5, 4, 0) within 5e-12
check [for piece in decompose(c): piece.points] ~= [
  [(-5, 4, 0), (-6, 4, 0), (-6, 2, 0), (-5, 0, 0)],
  [(-5, 0, 0), (-4, -2, 0), (-2, -4, 0), (0, -4, 0)],
  [(0, -4, 0), (2, -4, 0), (4, -2, 0), (5, 0, 0)],
  [(5, 0, 0), (6, 2, 0), (6, 4, 0), (5, 4, 0)],
] within 6e-12
