// Linkeová: Clamped bicubic surface composed of the four C2 patches (Example 3.15, Fig 3.21)
geo 1
let net = [
  [(0, 0, 2), (0, 1, 2), (0, 3, -2), (0, 5, 6), (0, 6, 0)],
  [(1, 0, 0), (1, 1, -1/9), (1, 3, -5/3), (1, 5, 31/9), (1, 6, 0)],
  [(3, 0, 0), (3, 1, -1/3), (3, 3, 3), (3, 5, 7/3), (3, 6, 0)],
  [(5, 0, 4), (5, 1, 7/9), (5, 3, 11/3), (5, 5, -73/9), (5, 6, 0)],
  [(6, 0, 0), (6, 1, 0), (6, 3, 0), (6, 5, 0), (6, 6, 0)],
]
surface s = clamped(net)
check s.points[0][0] ~= (0, 0, 2) within 2e-12
check s.points[0][1] ~= (0, 1, 2) within 2e-12
check s.points[0][2] ~= (0, 3, -2) within 3e-12
check s.points[0][3] ~= (0, 5, 6) within 6e-12
check s.points[0][4] ~= (0, 6, 0) within 6e-12
check s.points[1][0] ~= (1, 0, 0) within 1e-12
check s.points[1][1] ~= (1, 1, -1/9) within 1e-12
check s.points[1][2] ~= (1, 3, -5/3) within 3e-12
check s.points[1][3] ~= (1, 5, 31/9) within 5e-12
check s.points[1][4] ~= (1, 6, 0) within 6e-12
check s.points[2][0] ~= (3, 0, 0) within 3e-12
check s.points[2][1] ~= (3, 1, -1/3) within 3e-12
check s.points[2][2] ~= (3, 3, 3) within 3e-12
check s.points[2][3] ~= (3, 5, 7/3) within 5e-12
check s.points[2][4] ~= (3, 6, 0) within 6e-12
check s.points[3][0] ~= (5, 0, 4) within 5e-12
check s.points[3][1] ~= (5, 1, 7/9) within 5e-12
check s.points[3][2] ~= (5, 3, 11/3) within 5e-12
check s.points[3][3] ~= (5, 5, -73/9) within 8.11e-12
check s.points[3][4] ~= (5, 6, 0) within 6e-12
check s.points[4][0] ~= (6, 0, 0) within 6e-12
check s.points[4][1] ~= (6, 1, 0) within 6e-12
check s.points[4][2] ~= (6, 3, 0) within 6e-12
check s.points[4][3] ~= (6, 5, 0) within 6e-12
check s.points[4][4] ~= (6, 6, 0) within 6e-12
check [(len(unique(s.knots_u)) - 1), (len(unique(s.knots_v)) - 1)] == [2, 2]
check trim(s, u = 0..1, v = 0..1).points ~= [
  [(0, 0, 2), (0, 1, 2), (0, 2, 0), (0, 3, 1)],
  [(1, 0, 0), (1, 1, -1/9), (1, 2, -8/9), (1, 3, 0)],
  [(2, 0, 0), (2, 1, -2/9), (2, 2, 2/9), (2, 3, 1)],
  [(3, 0, 1), (3, 1, 0), (3, 2, 1), (3, 3, 1)],
] within 3e-12
check trim(s, u = 0..1, v = 1..2).points ~= [
  [(0, 3, 1), (0, 4, 2), (0, 5, 6), (0, 6, 0)],
  [(1, 3, 0), (1, 4, 8/9), (1, 5, 31/9), (1, 6, 0)],
  [(2, 3, 1), (2, 4, 16/9), (2, 5, 26/9), (2, 6, 0)],
  [(3, 3, 1), (3, 4, 1), (3, 5, 0), (3, 6, 0)],
] within 6e-12
check trim(s, u = 1..2, v = 0..1).points ~= [
  [(3, 0, 1), (3, 1, 0), (3, 2, 1), (3, 3, 1)],
  [(4, 0, 2), (4, 1, 2/9), (4, 2, 16/9), (4, 3, 1)],
  [(5, 0, 4), (5, 1, 7/9), (5, 2, 20/9), (5, 3, 0)],
  [(6, 0, 0), (6, 1, 0), (6, 2, 0), (6, 3, 0)],
] within 6e-12
check trim(s, u = 1..2, v = 1..2).points ~= [
  [(3, 3, 1), (3, 4, 1), (3, 5, 0), (3, 6, 0)],
  [(4, 3, 1), (4, 4, 2/9), (4, 5, -26/9), (4, 6, 0)],
  [(5, 3, 0), (5, 4, -20/9), (5, 5, -73/9), (5, 6, 0)],
  [(6, 3, 0), (6, 4, 0), (6, 5, 0), (6, 6, 0)],
] within 8.11e-12
check s(0.5, 0.5) ~= (3/2, 3/2, 1/8) within 1.5e-12
check derivative(s, 0.5, 0.5) ~= (3, 0, 0) within 3e-12
check derivative(s, 0.5, 0.5, du = 0, dv = 1) ~= (0, 3, 0) within 3e-12
check derivative(s, 0.5, 0.5, du = 2) ~= (0, 0, 6) within 6e-12
check twist(s, 0.5, 0.5) ~= (0, 0, 7/2) within 3.5e-12
check derivative(s, 0.5, 0.5, du = 0, dv = 2) ~= (0, 0, 3) within 3e-12
check normal(s, 0.5, 0.5) ~= (0, 0, 1) within 1e-12
check gaussian(s, 0.5, 0.5) ~= 23/324 within 1e-12
check mean(s, 0.5, 0.5) ~= 1/2 within 1e-12
check principal(s, 0.5, 0.5).k1 ~= 0.076901494118671762 within 1e-12
check principal(s, 0.5, 0.5).k2 ~= 0.92309850588132824 within 1e-12
check s(1.5, 0.5) ~= (9/2, 3/2, 71/64) within 4.5e-12
check derivative(s, 1.5, 0.5) ~= (3, 0, -3/32) within 3e-12
check derivative(s, 1.5, 0.5, du = 0, dv = 1) ~= (0, 3, -15/32) within 3e-12
check derivative(s, 1.5, 0.5, du = 2) ~= (0, 0, -51/8) within 6.37e-12
check twist(s, 1.5, 0.5) ~= (0, 0, -37/16) within 2.31e-12
check derivative(s, 1.5, 0.5, du = 0, dv = 2) ~= (0, 0, 21/8) within 2.62e-12
check normal(s, 1.5, 0.5) ~= (0.030860669992418382, 0.15430334996209191, 0.98754143975738823) within 1e-12
check gaussian(s, 1.5, 0.5) ~= -0.25928376025307242 within 1e-12
check mean(s, 1.5, 0.5) ~= -0.20762536262200803 within 1e-12
check principal(s, 1.5, 0.5).k1 ~= -0.75752721882636087 within 1e-12
check principal(s, 1.5, 0.5).k2 ~= 0.34227649358234481 within 1e-12
check s(1, 1) ~= (3, 3, 1) within 3e-12
check derivative(s, 1, 1) ~= (3, 0, 0) within 3e-12
check derivative(s, 1, 1, du = 0, dv = 1) ~= (0, 3, 0) within 3e-12
check derivative(s, 1, 1, du = 2) ~= (0, 0, -6) within 6e-12
check twist(s, 1, 1) ~= (0, 0, -7) within 7e-12
check derivative(s, 1, 1, du = 0, dv = 2) ~= (0, 0, -6) within 6e-12
check normal(s, 1, 1) ~= (0, 0, 1) within 1e-12
check gaussian(s, 1, 1) ~= -13/81 within 2.09e-12
check mean(s, 1, 1) ~= -2/3 within 2.09e-12
check principal(s, 1, 1).k1 ~= -13/9 within 2.09e-12
check principal(s, 1, 1).k2 ~= 1/9 within 2.09e-12
check s(1.5, 1.75) ~= (9/2, 21/4, -233/128) within 5.25e-12
check derivative(s, 1.5, 1.75) ~= (3, 0, -261/128) within 3e-12
check derivative(s, 1.5, 1.75, du = 0, dv = 1) ~= (0, 3, 45/16) within 3e-12
check derivative(s, 1.5, 1.75, du = 2) ~= (0, 0, 243/16) within 1.52e-11
check twist(s, 1.5, 1.75) ~= (0, 0, 157/32) within 4.91e-12
check derivative(s, 1.5, 1.75, du = 0, dv = 2) ~= (0, 0, 123/4) within 3.07e-11
check normal(s, 1.5, 1.75) ~= (0.44424196594693561, -0.61274753923715257, 0.65359737518629607) within 1e-12
check gaussian(s, 1.5, 1.75) ~= 0.99794206990527503 within 3.87e-12
check mean(s, 1.5, 1.75) ~= 1.2369655110336436 within 3.87e-12
check principal(s, 1.5, 1.75).k1 ~= 0.50748514420980092 within 3.87e-12
check principal(s, 1.5, 1.75).k2 ~= 1.9664458778574863 within 3.87e-12
