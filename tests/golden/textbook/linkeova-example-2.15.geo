// Linkeová: '@' sign: clamped control points (Example 2.15, Fig 2.28)
geo 1
let ctrl_k_star = [(47, 46), (29, 53), (23, 42), (22, 34), (21, 26), (25, 21), (31, 20), (37, 19), (45, 22), (47, 46)]
curves k_star = [for i in 0..2: bezier(ctrl_k_star[3*i..3*i + 3])]
let ctrl_k = [
  (47, 46), (48, 20), (54, 18), (58, 20), (62, 22), (64, 28), (64, 35), (64, 42), (62, 50), (55, 56),
  (48, 62), (36, 66), (26, 61), (16, 56), (8, 42), (9, 28), (10, 14), (20, 0), (47, 7),
]
curves k = [for i in 0..5: bezier(ctrl_k[3*i..3*i + 3])]
curve spline_k = clamped([(47, 46), (48, 20), (60, 16), (66, 34), (60, 58), (24, 70), (0, 28), (20, 0), (47, 7)])
check [for i in 0..5, t in linspace(0, 1, 5): spline_k(i + t)] ~= [for i in 0..5, t in linspace(0, 1, 5): k[i](t)] within 7e-11
curve spline_k_star = clamped([(47, 46), (29, 53), (17, 31), (29, 16), (45, 22), (47, 46)])
check [for i in 0..2, t in linspace(0, 1, 5): spline_k_star(i + t)] ~= [for i in 0..2, t in linspace(0, 1, 5): k_star[i](t)] within 5.3e-11
check [...flatten([for piece in decompose(spline_k): piece.points[0..2]]), spline_k.end] ~= [
  (47, 46, 0), (48, 20, 0), (54, 18, 0), (58, 20, 0), (62, 22, 0), (64, 28, 0), (64, 35, 0), (64, 42, 0),
  (62, 50, 0), (55, 56, 0), (48, 62, 0), (36, 66, 0), (26, 61, 0), (16, 56, 0), (8, 42, 0), (9, 28, 0),
  (10, 14, 0), (20, 0, 0), (47, 7, 0),
] within 6.6e-11
check [...flatten([for piece in decompose(spline_k_star): piece.points[0..2]]), spline_k_star.end] ~= [
  (47, 46, 0), (29, 53, 0), (23, 42, 0), (22, 34, 0), (21, 26, 0), (25, 21, 0), (31, 20, 0), (37, 19, 0),
  (45, 22, 0), (47, 46, 0),
] within 5.3e-11
check len(decompose(spline_k)) == 6
check len(decompose(spline_k_star)) == 3
