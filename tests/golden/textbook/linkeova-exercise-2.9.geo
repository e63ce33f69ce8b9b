// Linkeová: Curvature at the joints of the figure eight (Exercise 2.9)
geo 1
curve k_exercise_2_2 = hermite([(0, 0), (6, 0), (0, 0), (-6, 0), (0, 0)],
  [(9, 9), (0, -9), (-9, 9), (0, -9), (9, 9)])
check curvature(trim(k_exercise_2_2, 0..1), 0) ~= 0.078567420131838614 within 1e-12
check signed_curvature(trim(k_exercise_2_2, 0..1), 0) ~= -0.078567420131838614 within 1e-12
check curvature(trim(k_exercise_2_2, 0..1), 1) ~= 2/9 within 1e-12
check signed_curvature(trim(k_exercise_2_2, 0..1), 1) ~= -2/9 within 1e-12
check curvature(trim(k_exercise_2_2, 1..2), 1) ~= 2/9 within 1e-12
check signed_curvature(trim(k_exercise_2_2, 1..2), 1) ~= -2/9 within 1e-12
check curvature(trim(k_exercise_2_2, 1..2), 2) ~= 0.078567420131838614 within 1e-12
check signed_curvature(trim(k_exercise_2_2, 1..2), 2) ~= -0.078567420131838614 within 1e-12
check curvature(trim(k_exercise_2_2, 2..3), 2) ~= 0.078567420131838614 within 1e-12
check signed_curvature(trim(k_exercise_2_2, 2..3), 2) ~= 0.078567420131838614 within 1e-12
check curvature(trim(k_exercise_2_2, 2..3), 3) ~= 2/9 within 1e-12
check signed_curvature(trim(k_exercise_2_2, 2..3), 3) ~= 2/9 within 1e-12
check curvature(trim(k_exercise_2_2, 3..4), 3) ~= 2/9 within 1e-12
check signed_curvature(trim(k_exercise_2_2, 3..4), 3) ~= 2/9 within 1e-12
check curvature(trim(k_exercise_2_2, 3..4), 4) ~= 0.078567420131838614 within 1e-12
check signed_curvature(trim(k_exercise_2_2, 3..4), 4) ~= 0.078567420131838614 within 1e-12
