// Linkeová: P(1/2,1/2) and another parameter pair by both algorithms (Exercise 3.11)
geo 1
let net_ex_3_12 = [[(0, 0, 2), (0, 1, 0), (0, 2, 1)], [(1, 0, 0), (1, 1, 0), (1, 2, 0)], [(2, 0, 1), (2, 1, 0), (2, 2, 0)]]
surface s_ex_3_12 = bezier(net_ex_3_12)
check s_ex_3_12(1/2, 1/2) ~= (1, 1, 1/4) within 1e-12
check s_ex_3_12(1/4, 3/4) ~= (1/2, 3/2, 25/64) within 1.5e-12
