// Linkeova, Examples 2.11 to 2.13 and Exercises 2.16 to 2.24.
curve c = coons_cubic((-6, 0), (6, 0), (6, 6), (0, 6))
check c.domain == 0..1
check c(0) ~= (4, 1) within 1e-14
check derivative(c, 0) ~= (6, 3) within 1e-14
check derivative(c, 1) ~= (-3, 3) within 1e-14
check [for t in linspace(0, 1, 7): c(t)] ~= [for t in linspace(0, 1, 7): polynomial([(4, 1), (6, 3), (-6, 3), (1, -2)])(t)] within 1e-13

curve heart = coons_bspline((0, 6), (-6, 6), (-6, 0), (0, -6), (6, 0), (6, 6), (0, 6))
check heart.segments == 4
check heart.domain == 0..4

// Begins with the segment of points 0 to 3, and its seam is C2.
let corners = [(0, -10), (-6, 2), (6, 2), (0, -10)]
curve ring = coons_bspline(corners, closed = true)
check ring.closed
check ring.segments == 4
check [for piece in to_bezier(ring): piece.points] ~= [
  [(-3, 0, 0), (-2, 2, 0), (2, 2, 0), (3, 0, 0)],
  [(3, 0, 0), (4, -2, 0), (2, -6, 0), (1, -8, 0)],
  [(1, -8, 0), (0, -10, 0), (0, -10, 0), (-1, -8, 0)],
  [(-1, -8, 0), (-2, -6, 0), (-4, -2, 0), (-3, 0, 0)],
] within 1e-12
check [for k in 0..2: derivative(ring, 0, order = k)] ~= [for k in 0..2: derivative(ring, 4, order = k)] within 1e-12

// The same ring over 0..1, of any degree.
curve short = bspline(corners, closed = true)
check short.domain == 0..1
check [for i in 0..8: short(i/8)] ~= [for i in 0..8: ring(i/2)] within 1e-12
check bspline(corners, degree = 5, closed = true).closed
