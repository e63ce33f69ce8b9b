// Linkeová: Bezier cubic -> Coons cubic -> closed Coons cubic B-spline (Exercise 2.21)
geo 1
curve c = bezier((-3, 0), (-2, 2), (2, 2), (3, 0))
check to_coons(c).points ~= [(0, -10, 0), (-6, 2, 0), (6, 2, 0), (0, -10, 0)] within 1e-11
curve ring = coons_bspline(to_coons(c).points, closed = true)
let pieces = decompose(ring)
check len(decompose(ring)) == 4
check [for piece in decompose(ring): piece.points] ~= [
  [(-3, 0, 0), (-2, 2, 0), (2, 2, 0), (3, 0, 0)],
  [(3, 0, 0), (4, -2, 0), (2, -6, 0), (1, -8, 0)],
  [(1, -8, 0), (0, -10, 0), (0, -10, 0), (-1, -8, 0)],
  [(-1, -8, 0), (-2, -6, 0), (-4, -2, 0), (-3, 0, 0)],
] within 1e-11
