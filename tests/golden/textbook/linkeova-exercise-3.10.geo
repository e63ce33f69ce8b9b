// Linkeová: Inner control points (Exercise 3.10)
geo 1
curve c0_ex_3_11 = bezier((0, 0, 4), (1, 0, 1), (2, 0, 1), (3, 0, 4))
curve c1_ex_3_11 = bezier((0, 3, 1), (1, 3, 1), (2, 3, 1), (3, 3, 1))
curve d0_ex_3_11 = bezier((0, 0, 4), (0, 1, 4), (0, 2, 1), (0, 3, 1))
curve d1_ex_3_11 = bezier((3, 0, 4), (3, 1, 1), (3, 2, 1), (3, 3, 1))
surface s_ex_3_11 = coons(u = [c0_ex_3_11, c1_ex_3_11], v = [d0_ex_3_11, d1_ex_3_11])
check [for i in 1..2, j in 1..2: s_ex_3_11.points[i][j]] ~= [(1, 1, 1), (1, 2, 0), (2, 1, 0), (2, 2, 0)] within 2e-12
