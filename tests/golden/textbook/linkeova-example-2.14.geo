// Linkeová: '@' sign: Coons cubic B-spline control points (Example 2.14)
geo 1
let ctrl_k_star = [(47, 46), (29, 53), (23, 42), (22, 34), (21, 26), (25, 21), (31, 20), (37, 19), (45, 22), (47, 46)]
curves k_star = [for i in 0..2: bezier(ctrl_k_star[3*i..3*i + 3])]
let ctrl_k = [
  (47, 46), (48, 20), (54, 18), (58, 20), (62, 22), (64, 28), (64, 35), (64, 42), (62, 50), (55, 56),
  (48, 62), (36, 66), (26, 61), (16, 56), (8, 42), (9, 28), (10, 14), (20, 0), (47, 7),
]
curves k = [for i in 0..5: bezier(ctrl_k[3*i..3*i + 3])]
curve spline_k_star = coons_bspline([(125, -11), (35, 64), (17, 31), (29, 16), (53, 25), (41, 160)])
check [for i in 0..2, t in linspace(0, 1, 5): spline_k_star(i + t)] ~= [for i in 0..2, t in linspace(0, 1, 5): k_star[i](t)] within 1.6e-12
curve spline_k = coons_bspline([(54, 172), (42, 22), (60, 16), (66, 34), (60, 58), (24, 70), (0, 28), (30, -14), (162, 70)])
check [for i in 0..5, t in linspace(0, 1, 5): spline_k(i + t)] ~= [for i in 0..5, t in linspace(0, 1, 5): k[i](t)] within 1.72e-12
