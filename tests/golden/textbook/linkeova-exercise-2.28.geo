// Linkeová: Clamped curves of Fig 2.26: knots and curvature comb values (Exercise 2.28)
geo 1
curve c_exercise_2_26a = clamped([(1, 1), (3, 1), (5, 7), (7, 1), (9, 4)])
check signed_curvature(c_exercise_2_26a, 0) ~= 1/2 within 1e-12
check signed_curvature(c_exercise_2_26a, 0.5) ~= 0.067166887833650347 within 1e-12
check signed_curvature(c_exercise_2_26a, 1) ~= -2 within 2e-12
check signed_curvature(c_exercise_2_26a, 1.5) ~= 0.48423129922590731 within 1e-12
check signed_curvature(c_exercise_2_26a, 2) ~= 0.12800773759043749 within 1e-12
curve c_exercise_2_26b = clamped([(4, 1), (1, 3), (1, 7), (7, 7), (7, 3), (10, 1)])
check signed_curvature(c_exercise_2_26b, 0) ~= -0.085338491726958326 within 1e-12
check signed_curvature(c_exercise_2_26b, 0.5) ~= -0.3593836138531738 within 1e-12
check signed_curvature(c_exercise_2_26b, 1) ~= -0.47140452079103168 within 1e-12
check signed_curvature(c_exercise_2_26b, 1.5) ~= -8/27 within 1e-12
check signed_curvature(c_exercise_2_26b, 3) ~= 0.085338491726958326 within 1e-12
curve c_exercise_2_26c = clamped([(3, 1), (1, 3), (3, 7), (6, 1), (9, 7), (7, 7), (6, 5)])
check signed_curvature(c_exercise_2_26c, 0) ~= -0.17677669529663688 within 1e-12
check signed_curvature(c_exercise_2_26c, 0.5) ~= -0.47394302646589489 within 1e-12
check signed_curvature(c_exercise_2_26c, 1) ~= -4/3 within 1.33e-12
check signed_curvature(c_exercise_2_26c, 1.5) ~= 0 within 1e-12
check signed_curvature(c_exercise_2_26c, 4) ~= 0.11925695879998878 within 1e-12
curve c_exercise_2_26d = clamped([(4, 5), (3, 7), (1, 7), (4, 1), (7, 7), (10, 1), (8, 1), (7, 3)])
check signed_curvature(c_exercise_2_26d, 0) ~= 0.11925695879998878 within 1e-12
check signed_curvature(c_exercise_2_26d, 0.5) ~= 1.3492384683385085 within 1.35e-12
check signed_curvature(c_exercise_2_26d, 1) ~= 2/3 within 1e-12
check signed_curvature(c_exercise_2_26d, 1.5) ~= 0.21521391076706991 within 1e-12
check signed_curvature(c_exercise_2_26d, 5) ~= -0.11925695879998878 within 1e-12
