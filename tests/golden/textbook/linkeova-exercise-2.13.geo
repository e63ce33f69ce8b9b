// Linkeová: Mid points and end curvatures of Ex 2.8 and 2.10 (Exercise 2.13)
geo 1
curve p_ex_2_8 = bezier((-1, 1), (0, 0), (1, 1))
check p_ex_2_8(1/2) ~= (0, 1/2, 0) within 1e-12
check signed_curvature(p_ex_2_8, 0) ~= 0.35355339059327376 within 1e-12
check signed_curvature(p_ex_2_8, 1) ~= 0.35355339059327376 within 1e-12
curve r_ex_2_8 = continue_bezier(p_ex_2_8, 1, [(0, 2)])
check r_ex_2_8(1/2) ~= (5/4, 7/4, 0) within 1.75e-12
check signed_curvature(r_ex_2_8, 0) ~= 0.35355339059327376 within 1e-12
check signed_curvature(r_ex_2_8, 1) ~= 1/8 within 1e-12
curve s_ex_2_8 = continue_bezier(r_ex_2_8, 1, [(-1, 1)])
check s_ex_2_8(1/2) ~= (-5/4, 7/4, 0) within 1.75e-12
check signed_curvature(s_ex_2_8, 0) ~= 1/8 within 1e-12
check signed_curvature(s_ex_2_8, 1) ~= 0.35355339059327376 within 1e-12
curve p_ex_2_10 = bezier((4, 1), (5, 0), (7, 0), (8, 2))
curve r_ex_2_10 = reversed(continue_bezier(reversed(p_ex_2_10), 2, [(0, 4)]))
check r_ex_2_10(1/2) ~= (11/4, 23/8, 0) within 2.87e-12
check signed_curvature(r_ex_2_10, 0) ~= -4/27 within 1e-12
check signed_curvature(r_ex_2_10, 1) ~= 0.47140452079103168 within 1e-12
check p_ex_2_10(1/2) ~= (6, 3/8, 0) within 6e-12
check signed_curvature(p_ex_2_10, 0) ~= 0.47140452079103168 within 1e-12
check signed_curvature(p_ex_2_10, 1) ~= 0.23851391759997757 within 1e-12
curve s_ex_2_10 = continue_bezier(p_ex_2_10, 2, [(0, 4)])
check s_ex_2_10(1/2) ~= (31/4, 21/4, 0) within 7.75e-12
check signed_curvature(s_ex_2_10, 0) ~= 0.23851391759997757 within 1e-12
check signed_curvature(s_ex_2_10, 1) ~= 0.025121966972378203 within 1e-12
