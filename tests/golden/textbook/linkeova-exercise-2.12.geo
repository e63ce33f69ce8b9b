// Linkeová: Point P(1/2) of the degree 6 Bezier curve (Exercise 2.12)
geo 1
curve c_ex_2_7 = bezier([(0, 2), (7, 9), (17, 9), (20, 4), (16, 0), (10, 0), (6, 4)])
check c_ex_2_7(1/2) ~= (1003/64, 275/64, 0) within 1.57e-11
