// Linkeová: Close a Bezier cubic with C2 Bezier cubics via the Coons B-spline (Exercise 2.22)
geo 1
curve c = bezier((1, 5), (2, 6), (4, 6), (6, 5))
check to_coons(c).points ~= [(0, 0, 0), (0, 6, 0), (6, 6, 0), (12, 0, 0)] within 1.2e-11
curve ring = coons_bspline(to_coons(c).points, closed = true)
let pieces = decompose(ring)
check [for piece in decompose(ring): piece.points] ~= [
  [(1, 5, 0), (2, 6, 0), (4, 6, 0), (6, 5, 0)],
  [(6, 5, 0), (8, 4, 0), (10, 2, 0), (9, 1, 0)],
  [(9, 1, 0), (8, 0, 0), (4, 0, 0), (2, 1, 0)],
  [(2, 1, 0), (0, 2, 0), (0, 4, 0), (1, 5, 0)],
] within 1e-11
check continuity(pieces[0], pieces[1]).c == 2
check continuity(pieces[1], pieces[2]).c == 2
check continuity(pieces[2], pieces[3]).c == 2
check continuity(pieces[3], pieces[0]).c == 2
