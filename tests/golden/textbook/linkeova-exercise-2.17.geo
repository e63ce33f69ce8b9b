// Linkeová: Coons -> Bezier and back (Exercise 2.17)
geo 1
curve c_ex_2_12 = coons_cubic((-6, 0), (6, 0), (6, 6), (0, 6))
check decompose(c_ex_2_12)[0].points ~= [(4, 1, 0), (6, 2, 0), (6, 4, 0), (5, 5, 0)] within 6e-12
check to_coons(c_ex_2_12).points ~= [(-6, 0, 0), (6, 0, 0), (6, 6, 0), (0, 6, 0)] within 6e-12
