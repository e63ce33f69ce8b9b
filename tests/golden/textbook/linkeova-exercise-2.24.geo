// Linkeová: Exercise 2.23 closed: P20=P0 already, append P1, P2 (Exercise 2.24)
geo 1
curve c = coons_bspline([
  (3, 9), (9, 3), (3, -3), (0, 0), (3, 3), (9, -3), (3, -9), (-3, -3), (0, 0), (3, -3), (-3, -9), (-9, -3),
  (-3, 3), (0, 0), (-3, -3), (-9, 3), (-3, 9), (3, 3), (0, 0), (-3, 3), (3, 9), (9, 3), (3, -3),
])
let pieces = decompose(c)
check len(decompose(c)) == 20
check c(0) ~= (7, 3, 0) within 7e-12
check derivative(c, 0) ~= (0, -6, 0) within 6e-12
check c(1) ~= (7/2, -3/2, 0) within 3.5e-12
check derivative(c, 1) ~= (-9/2, -3/2, 0) within 4.5e-12
check c(2) ~= (1, 0, 0) within 1e-12
check derivative(c, 2) ~= (0, 3, 0) within 3e-12
check c(3) ~= (7/2, 3/2, 0) within 3.5e-12
check derivative(c, 3) ~= (9/2, -3/2, 0) within 4.5e-12
check c(4) ~= (7, -3, 0) within 7e-12
check derivative(c, 4) ~= (0, -6, 0) within 6e-12
check c(5) ~= (3, -7, 0) within 7e-12
check derivative(c, 5) ~= (-6, 0, 0) within 6e-12
check c(6) ~= (-3/2, -7/2, 0) within 3.5e-12
check derivative(c, 6) ~= (-3/2, 9/2, 0) within 4.5e-12
check c(7) ~= (0, -1, 0) within 1e-12
check derivative(c, 7) ~= (3, 0, 0) within 3e-12
check c(8) ~= (3/2, -7/2, 0) within 3.5e-12
check derivative(c, 8) ~= (-3/2, -9/2, 0) within 4.5e-12
check c(9) ~= (-3, -7, 0) within 7e-12
check derivative(c, 9) ~= (-6, 0, 0) within 6e-12
check c(10) ~= (-7, -3, 0) within 7e-12
check derivative(c, 10) ~= (0, 6, 0) within 6e-12
check c(11) ~= (-7/2, 3/2, 0) within 3.5e-12
check derivative(c, 11) ~= (9/2, 3/2, 0) within 4.5e-12
check c(12) ~= (-1, 0, 0) within 1e-12
check derivative(c, 12) ~= (0, -3, 0) within 3e-12
check c(13) ~= (-7/2, -3/2, 0) within 3.5e-12
check derivative(c, 13) ~= (-9/2, 3/2, 0) within 4.5e-12
check c(14) ~= (-7, 3, 0) within 7e-12
check derivative(c, 14) ~= (0, 6, 0) within 6e-12
check c(15) ~= (-3, 7, 0) within 7e-12
check derivative(c, 15) ~= (6, 0, 0) within 6e-12
check c(16) ~= (3/2, 7/2, 0) within 3.5e-12
check derivative(c, 16) ~= (3/2, -9/2, 0) within 4.5e-12
check c(17) ~= (0, 1, 0) within 1e-12
check derivative(c, 17) ~= (-3, 0, 0) within 3e-12
check c(18) ~= (-3/2, 7/2, 0) within 3.5e-12
check derivative(c, 18) ~= (3/2, 9/2, 0) within 4.5e-12
check c(19) ~= (3, 7, 0) within 7e-12
check derivative(c, 19) ~= (6, 0, 0) within 6e-12
check c(20) ~= (7, 3, 0) within 7e-12
check derivative(c, 20) ~= (0, -6, 0) within 6e-12
check [for piece in decompose(c): piece.points] ~= [
  [(7, 3, 0), (7, 1, 0), (5, -1, 0), (7/2, -3/2, 0)],
  [(7/2, -3/2, 0), (2, -2, 0), (1, -1, 0), (1, 0, 0)],
  [(1, 0, 0), (1, 1, 0), (2, 2, 0), (7/2, 3/2, 0)],
  [(7/2, 3/2, 0), (5, 1, 0), (7, -1, 0), (7, -3, 0)],
  [(7, -3, 0), (7, -5, 0), (5, -7, 0), (3, -7, 0)],
  [(3, -7, 0), (1, -7, 0), (-1, -5, 0), (-3/2, -7/2, 0)],
  [(-3/2, -7/2, 0), (-2, -2, 0), (-1, -1, 0), (0, -1, 0)],
  [(0, -1, 0), (1, -1, 0), (2, -2, 0), (3/2, -7/2, 0)],
  [(3/2, -7/2, 0), (1, -5, 0), (-1, -7, 0), (-3, -7, 0)],
  [(-3, -7, 0), (-5, -7, 0), (-7, -5, 0), (-7, -3, 0)],
  [(-7, -3, 0), (-7, -1, 0), (-5, 1, 0), (-7/2, 3/2, 0)],
  [(-7/2, 3/2, 0), (-2, 2, 0), (-1, 1, 0), (-1, 0, 0)],
  [(-1, 0, 0), (-1, -1, 0), (-2, -2, 0), (-7/2, -3/2, 0)],
  [(-7/2, -3/2, 0), (-5, -1, 0), (-7, 1, 0), (-7, 3, 0)],
  [(-7, 3, 0), (-7, 5, 0), (-5, 7, 0), (-3, 7, 0)],
  [(-3, 7, 0), (-1, 7, 0), (1, 5, 0), (3/2, 7/2, 0)],
  [(3/2, 7/2, 0), (2, 2, 0), (1, 1, 0), (0, 1, 0)],
  [(0, 1, 0), (-1, 1, 0), (-2, 2, 0), (-3/2, 7/2, 0)],
  [(-3/2, 7/2, 0), (-1, 5, 0), (1, 7, 0), (3, 7, 0)],
  [(3, 7, 0), (5, 7, 0), (7, 5, 0), (7, 3, 0)],
] within 7e-12
check continuity(pieces[0], pieces[1]).c == 2
check continuity(pieces[1], pieces[2]).c == 2
check continuity(pieces[2], pieces[3]).c == 2
check continuity(pieces[3], pieces[4]).c == 2
check continuity(pieces[4], pieces[5]).c == 2
check continuity(pieces[5], pieces[6]).c == 2
check continuity(pieces[6], pieces[7]).c == 2
check continuity(pieces[7], pieces[8]).c == 2
check continuity(pieces[8], pieces[9]).c == 2
check continuity(pieces[9], pieces[10]).c == 2
check continuity(pieces[10], pieces[11]).c == 2
check continuity(pieces[11], pieces[12]).c == 2
check continuity(pieces[12], pieces[13]).c == 2
check continuity(pieces[13], pieces[14]).c == 2
check continuity(pieces[14], pieces[15]).c == 2
check continuity(pieces[15], pieces[16]).c == 2
check continuity(pieces[16], pieces[17]).c == 2
check continuity(pieces[17], pieces[18]).c == 2
check continuity(pieces[18], pieces[19]).c == 2
check is_closed(c)
check continuity(pieces[19], pieces[0]).c == 2
check c.knots ~= [-3, -2, -1, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23] within 2.3e-11
check to_clamped(c).points ~= [
  (7, 3, 0), (7, 1, 0), (3, -3, 0), (0, 0, 0), (3, 3, 0), (9, -3, 0), (3, -9, 0), (-3, -3, 0), (0, 0, 0),
  (3, -3, 0), (-3, -9, 0), (-9, -3, 0), (-3, 3, 0), (0, 0, 0), (-3, -3, 0), (-9, 3, 0), (-3, 9, 0),
  (3, 3, 0), (0, 0, 0), (-3, 3, 0), (3, 9, 0), (7, 5, 0), (7, 3, 0),
] within 9e-12
check to_clamped(c).knots ~= [0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 20, 20, 20] within 2e-11
