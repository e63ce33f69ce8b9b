// Linkeová: Corner points: elliptic / hyperbolic / parabolic, boundary points (Exercise 3.8)
geo 1
let net_ex_3_7 = [[(0, 0, 2), (0, 1, 1), (0, 2, 3)], [(1, 0, 3), (1, 1, 0), (1, 2, 0)], [(2, 0, 1), (2, 1, 0), (2, 2, 0)]]
surface s_ex_3_7 = bezier(net_ex_3_7)
check gaussian(s_ex_3_7, 0, 0) ~= -0.69444444444444444 within 1e-11
check mean(s_ex_3_7, 0, 0) ~= -0.38490017945975051 within 1e-11
check classify(s_ex_3_7, 0, 0) == "hyperbolic"
check gaussian(s_ex_3_7, 0, 1) ~= -0.0089285714285714286 within 1e-11
check mean(s_ex_3_7, 0, 1) ~= -0.014317566531022735 within 1e-11
check classify(s_ex_3_7, 0, 1) == "hyperbolic"
check gaussian(s_ex_3_7, 1, 0) ~= -0.13194444444444444 within 1e-11
check mean(s_ex_3_7, 1, 0) ~= -0.28917587241190297 within 1e-11
check classify(s_ex_3_7, 1, 0) == "hyperbolic"
check gaussian(s_ex_3_7, 1, 1) ~= 3/4 within 1e-11
check mean(s_ex_3_7, 1, 1) ~= 1 within 1e-11
check classify(s_ex_3_7, 1, 1) == "elliptic"
check s_ex_3_7(0, 0) ~= (0, 0, 2) within 2e-12
check s_ex_3_7(0, 0.1) ~= (0, 1/5, 183/100) within 1.83e-12
check s_ex_3_7(0.1, 0) ~= (1/5, 0, 217/100) within 2.17e-12
check s_ex_3_7(0, 0.2) ~= (0, 2/5, 43/25) within 1.72e-12
check s_ex_3_7(0.2, 0) ~= (2/5, 0, 57/25) within 2.28e-12
check s_ex_3_7(0, 0.3) ~= (0, 3/5, 167/100) within 1.67e-12
check s_ex_3_7(0.3, 0) ~= (3/5, 0, 233/100) within 2.33e-12
check s_ex_3_7(0, 0.4) ~= (0, 4/5, 42/25) within 1.68e-12
check s_ex_3_7(0.4, 0) ~= (4/5, 0, 58/25) within 2.32e-12
check s_ex_3_7(0, 0.5) ~= (0, 1, 7/4) within 1.75e-12
check s_ex_3_7(0.5, 0) ~= (1, 0, 9/4) within 2.25e-12
check s_ex_3_7(0, 0.6) ~= (0, 6/5, 47/25) within 1.88e-12
check s_ex_3_7(0.6, 0) ~= (6/5, 0, 53/25) within 2.12e-12
check s_ex_3_7(0, 0.7) ~= (0, 7/5, 207/100) within 2.07e-12
check s_ex_3_7(0.7, 0) ~= (7/5, 0, 193/100) within 1.93e-12
check s_ex_3_7(0, 0.8) ~= (0, 8/5, 58/25) within 2.32e-12
check s_ex_3_7(0.8, 0) ~= (8/5, 0, 42/25) within 1.68e-12
check s_ex_3_7(0, 0.9) ~= (0, 9/5, 263/100) within 2.63e-12
check s_ex_3_7(0.9, 0) ~= (9/5, 0, 137/100) within 1.8e-12
check s_ex_3_7(0, 1) ~= (0, 2, 3) within 3e-12
check s_ex_3_7(1, 0) ~= (2, 0, 1) within 2e-12
let net_ex_3_8 = [
  [(0, 0, 5), (0, 1, 5), (0, 2, 2), (0, 3, 5)],
  [(1, 0, 2), (1, 1, 1), (1, 2, 0), (1, 3, 2)],
  [(2, 0, 5), (2, 1, 2), (2, 2, 2), (2, 3, 2)],
]
surface s_ex_3_8 = bezier(net_ex_3_8)
check gaussian(s_ex_3_8, 0, 0) ~= -0.07 within 1e-11
check mean(s_ex_3_8, 0, 0) ~= -0.26879360111431224 within 1e-11
check classify(s_ex_3_8, 0, 0) == "hyperbolic"
check gaussian(s_ex_3_8, 0, 1) ~= 0.013850415512465374 within 1e-11
check mean(s_ex_3_8, 0, 1) ~= 0.2233784777160733 within 1e-11
check classify(s_ex_3_8, 0, 1) == "elliptic"
check gaussian(s_ex_3_8, 1, 0) ~= 0.0055401662049861496 within 1e-11
check mean(s_ex_3_8, 1, 0) ~= 0.084521586162838545 within 1e-11
check classify(s_ex_3_8, 1, 0) == "elliptic"
check gaussian(s_ex_3_8, 1, 1) ~= -4 within 1e-11
check mean(s_ex_3_8, 1, 1) ~= 3/4 within 1e-11
check classify(s_ex_3_8, 1, 1) == "hyperbolic"
check s_ex_3_8(0, 0) ~= (0, 0, 5) within 5e-12
check s_ex_3_8(0, 0.1) ~= (0, 3/10, 4919/1000) within 4.92e-12
check s_ex_3_8(0.1, 0) ~= (1/5, 0, 223/50) within 4.46e-12
check s_ex_3_8(0, 0.2) ~= (0, 3/5, 589/125) within 4.71e-12
check s_ex_3_8(0.2, 0) ~= (2/5, 0, 101/25) within 4.04e-12
check s_ex_3_8(0, 0.3) ~= (0, 9/10, 4433/1000) within 4.43e-12
check s_ex_3_8(0.3, 0) ~= (3/5, 0, 187/50) within 3.74e-12
check s_ex_3_8(0, 0.4) ~= (0, 6/5, 517/125) within 4.14e-12
check s_ex_3_8(0.4, 0) ~= (4/5, 0, 89/25) within 3.56e-12
check s_ex_3_8(0, 0.5) ~= (0, 3/2, 31/8) within 3.87e-12
check s_ex_3_8(0.5, 0) ~= (1, 0, 7/2) within 3.5e-12
check s_ex_3_8(0, 0.6) ~= (0, 9/5, 463/125) within 3.7e-12
check s_ex_3_8(0.6, 0) ~= (6/5, 0, 89/25) within 3.56e-12
check s_ex_3_8(0, 0.7) ~= (0, 21/10, 3677/1000) within 3.68e-12
check s_ex_3_8(0.7, 0) ~= (7/5, 0, 187/50) within 3.74e-12
check s_ex_3_8(0, 0.8) ~= (0, 12/5, 481/125) within 3.85e-12
check s_ex_3_8(0.8, 0) ~= (8/5, 0, 101/25) within 4.04e-12
check s_ex_3_8(0, 0.9) ~= (0, 27/10, 4271/1000) within 4.27e-12
check s_ex_3_8(0.9, 0) ~= (9/5, 0, 223/50) within 4.46e-12
check s_ex_3_8(0, 1) ~= (0, 3, 5) within 5e-12
check s_ex_3_8(1, 0) ~= (2, 0, 5) within 5e-12
