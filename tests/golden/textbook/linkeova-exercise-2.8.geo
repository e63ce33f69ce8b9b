// Linkeová: Ferguson curves drawn as Bezier cubics (Exercise 2.8)
geo 1
curve c_ex_2_1 = hermite([(1, 0), (4, 2)], [(-1, 3), (2, -2)])
check decompose(c_ex_2_1)[0].points ~= [(1, 0, 0), (2/3, 1, 0), (10/3, 8/3, 0), (4, 2, 0)] within 4e-12
curve c_exercise_2_1a = hermite([(0, 0), (2, 0)], [(0, 1), (0, -1)])
check decompose(c_exercise_2_1a)[0].points ~= [(0, 0, 0), (0, 1/3, 0), (2, 1/3, 0), (2, 0, 0)] within 2e-12
curve c_exercise_2_1b = hermite([(0, 0), (2, 0)], [(-1, 1), (1, -1)])
check decompose(c_exercise_2_1b)[0].points ~= [(0, 0, 0), (-1/3, 1/3, 0), (5/3, 1/3, 0), (2, 0, 0)] within 2e-12
curve c_exercise_2_1c = hermite([(0, 0), (2, 0)], [(1, 1), (1, 1)])
check decompose(c_exercise_2_1c)[0].points ~= [(0, 0, 0), (1/3, 1/3, 0), (5/3, -1/3, 0), (2, 0, 0)] within 2e-12
curve c_exercise_2_1d = hermite([(0, 0), (2, 0)], [(-1, -1), (-1, -1)])
check decompose(c_exercise_2_1d)[0].points ~= [(0, 0, 0), (-1/3, -1/3, 0), (7/3, 1/3, 0), (2, 0, 0)] within 2.33e-12
