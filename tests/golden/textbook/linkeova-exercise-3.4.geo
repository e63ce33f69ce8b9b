// Linkeová: Points on the boundaries of both hyperbolic paraboloids (Exercise 3.4)
geo 1
surface s_ex_3_4 = bilinear((0, 0, 2), (0, 2, 2), (2, 0, 1), (2, 2, 0))
check s_ex_3_4(0, 0) ~= (0, 0, 2) within 2e-12
check s_ex_3_4(0, 0.2) ~= (0, 2/5, 2) within 2e-12
check s_ex_3_4(0.2, 0) ~= (2/5, 0, 9/5) within 1.8e-12
check s_ex_3_4(0, 0.4) ~= (0, 4/5, 2) within 2e-12
check s_ex_3_4(0.4, 0) ~= (4/5, 0, 8/5) within 1.6e-12
check s_ex_3_4(0, 0.6) ~= (0, 6/5, 2) within 2e-12
check s_ex_3_4(0.6, 0) ~= (6/5, 0, 7/5) within 1.4e-12
check s_ex_3_4(0, 0.8) ~= (0, 8/5, 2) within 2e-12
check s_ex_3_4(0.8, 0) ~= (8/5, 0, 6/5) within 1.6e-12
check s_ex_3_4(0, 1) ~= (0, 2, 2) within 2e-12
check s_ex_3_4(1, 0) ~= (2, 0, 1) within 2e-12
surface s_exercise_3_3 = bilinear((0, 0, 2), (0, 3, 0), (3, 0, 0), (3, 3, 0))
check s_exercise_3_3(0, 0) ~= (0, 0, 2) within 2e-12
check s_exercise_3_3(0, 0.2) ~= (0, 3/5, 8/5) within 1.6e-12
check s_exercise_3_3(0.2, 0) ~= (3/5, 0, 8/5) within 1.6e-12
check s_exercise_3_3(0, 0.4) ~= (0, 6/5, 6/5) within 1.2e-12
check s_exercise_3_3(0.4, 0) ~= (6/5, 0, 6/5) within 1.2e-12
check s_exercise_3_3(0, 0.6) ~= (0, 9/5, 4/5) within 1.8e-12
check s_exercise_3_3(0.6, 0) ~= (9/5, 0, 4/5) within 1.8e-12
check s_exercise_3_3(0, 0.8) ~= (0, 12/5, 2/5) within 2.4e-12
check s_exercise_3_3(0.8, 0) ~= (12/5, 0, 2/5) within 2.4e-12
check s_exercise_3_3(0, 1) ~= (0, 3, 0) within 3e-12
check s_exercise_3_3(1, 0) ~= (3, 0, 0) within 3e-12
