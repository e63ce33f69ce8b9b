// Linkeová: Osculating circle at the common point (Exercise 2.14)
geo 1
curve r_ex_2_9 = bezier((1, 0), (2, 0), (2, 1), (2, 2))
check center_of_curvature(r_ex_2_9, 0) ~= (1, 3/2, 0) within 1.5e-12
check radius_of_curvature(r_ex_2_9, 0) ~= 3/2 within 1.5e-12
