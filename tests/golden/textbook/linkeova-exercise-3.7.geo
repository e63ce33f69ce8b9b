// Linkeová: P(1/2,1/2) of all surfaces of Exercise 3.5 (Exercise 3.7)
geo 1
surface s_exercise_3_5_1a = bilinear((0, 0, 2), (0, 2, 1), (2, 0, 2), (2, 2, 1))
check s_exercise_3_5_1a(1/2, 1/2) ~= (1, 1, 3/2) within 1.5e-12
surface s_exercise_3_5_1b = bilinear((0, 0, 2), (0, 3, 1), (3, 0, 1), (3, 3, 1))
check s_exercise_3_5_1b(1/2, 1/2) ~= (3/2, 3/2, 5/4) within 1.5e-12
curve rail0_exercise_3_5_2a = bezier((0, 0, 2), (1, 0, 0), (2, 0, 2))
curve rail1_exercise_3_5_2a = bezier((0, 2, 1), (1, 2, 0), (2, 2, 1))
surface s_exercise_3_5_2a = ruled(rail0_exercise_3_5_2a, rail1_exercise_3_5_2a)
check s_exercise_3_5_2a(1/2, 1/2) ~= (1, 1, 3/4) within 1e-12
curve rail0_exercise_3_5_2b = bezier((0, 0, 2), (0, 1, 2), (0, 2, 1))
curve rail1_exercise_3_5_2b = bezier((2, 0, 2), (2, 1, 0), (2, 2, 1))
surface s_exercise_3_5_2b = swap_uv(ruled(rail0_exercise_3_5_2b, rail1_exercise_3_5_2b))
check s_exercise_3_5_2b(1/2, 1/2) ~= (1, 1, 5/4) within 1.25e-12
curve c0_exercise_3_5_2c = bezier((0, 0, 2), (1, 0, 0), (2, 0, 2))
curve c1_exercise_3_5_2c = bezier((0, 2, 1), (1, 2, 0), (2, 2, 1))
curve d0_exercise_3_5_2c = bezier((0, 0, 2), (0, 1, 2), (0, 2, 1))
curve d1_exercise_3_5_2c = bezier((2, 0, 2), (2, 1, 0), (2, 2, 1))
surface s_exercise_3_5_2c = coons(u = [c0_exercise_3_5_2c, c1_exercise_3_5_2c], v = [d0_exercise_3_5_2c, d1_exercise_3_5_2c])
check s_exercise_3_5_2c(1/2, 1/2) ~= (1, 1, 1/2) within 1e-12
curve rail0_exercise_3_5_2d = bezier((0, 0, 3), (1, 0, 0), (2, 0, 0), (3, 0, 1))
curve rail1_exercise_3_5_2d = bezier((0, 3, 2), (1, 3, 0), (2, 3, 1), (3, 3, 0))
surface s_exercise_3_5_2d = ruled(rail0_exercise_3_5_2d, rail1_exercise_3_5_2d)
check s_exercise_3_5_2d(1/2, 1/2) ~= (3/2, 3/2, 9/16) within 1.5e-12
curve rail0_exercise_3_5_2e = bezier((0, 0, 3), (0, 1, 2), (0, 2, 0), (0, 3, 2))
curve rail1_exercise_3_5_2e = bezier((3, 0, 1), (3, 1, 0), (3, 2, 1), (3, 3, 0))
surface s_exercise_3_5_2e = swap_uv(ruled(rail0_exercise_3_5_2e, rail1_exercise_3_5_2e))
check s_exercise_3_5_2e(1/2, 1/2) ~= (3/2, 3/2, 15/16) within 1.5e-12
curve c0_exercise_3_5_2f = bezier((0, 0, 3), (1, 0, 0), (2, 0, 0), (3, 0, 1))
curve c1_exercise_3_5_2f = bezier((0, 3, 2), (1, 3, 0), (2, 3, 1), (3, 3, 0))
curve d0_exercise_3_5_2f = bezier((0, 0, 3), (0, 1, 2), (0, 2, 0), (0, 3, 2))
curve d1_exercise_3_5_2f = bezier((3, 0, 1), (3, 1, 0), (3, 2, 1), (3, 3, 0))
surface s_exercise_3_5_2f = coons(u = [c0_exercise_3_5_2f, c1_exercise_3_5_2f], v = [d0_exercise_3_5_2f, d1_exercise_3_5_2f])
check s_exercise_3_5_2f(1/2, 1/2) ~= (3/2, 3/2, 0) within 1.5e-12
