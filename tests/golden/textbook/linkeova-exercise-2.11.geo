// Linkeová: '@' sign: curvature at the knots (Exercise 2.11)
geo 1
curve k_star_ex_2_6 = hermite([(47, 46), (22, 34), (31, 20), (47, 46)],
  [(-54, 21), (-3, -24), (18, -3), (6, 72)])
check signed_curvature(trim(k_star_ex_2_6, 0..1), 0) ~= 0.022210418148139313 within 1e-12
check signed_curvature(trim(k_star_ex_2_6, 0..1), 1) ~= 0.047069591587699619 within 1e-12
check signed_curvature(trim(k_star_ex_2_6, 1..2), 1) ~= 0.047069591587699619 within 1e-12
check signed_curvature(trim(k_star_ex_2_6, 1..2), 2) ~= 0.077015741800707919 within 1e-12
check signed_curvature(trim(k_star_ex_2_6, 2..3), 2) ~= 0.077015741800707919 within 1e-12
check signed_curvature(trim(k_star_ex_2_6, 2..3), 3) ~= 0.0088772754326411691 within 1e-12
curve k_ex_2_6 = hermite([(47, 46), (58, 20), (64, 35), (55, 56), (26, 61), (9, 28), (47, 7)],
  [(3, -78), (12, 6), (0, 21), (-21, 18), (-30, -15), (3, -42), (81, 21)])
check signed_curvature(trim(k_ex_2_6, 0..1), 0) ~= 0.0058283612049093813 within 1e-12
check signed_curvature(trim(k_ex_2_6, 0..1), 1) ~= 0.14907119849998598 within 1e-12
check signed_curvature(trim(k_ex_2_6, 1..2), 1) ~= 0.14907119849998598 within 1e-12
check signed_curvature(trim(k_ex_2_6, 1..2), 2) ~= 4/147 within 1e-12
check signed_curvature(trim(k_ex_2_6, 2..3), 2) ~= 4/147 within 1e-12
check signed_curvature(trim(k_ex_2_6, 2..3), 3) ~= 0.037431137819689692 within 1e-12
check signed_curvature(trim(k_ex_2_6, 3..4), 3) ~= 0.037431137819689692 within 1e-12
check signed_curvature(trim(k_ex_2_6, 3..4), 4) ~= 0.047702783519995514 within 1e-12
check signed_curvature(trim(k_ex_2_6, 4..5), 4) ~= 0.047702783519995514 within 1e-12
check signed_curvature(trim(k_ex_2_6, 4..5), 5) ~= 0.030379452786722893 within 1e-12
check signed_curvature(trim(k_ex_2_6, 5..6), 5) ~= 0.030379452786722893 within 1e-12
check signed_curvature(trim(k_ex_2_6, 5..6), 6) ~= 0.01376313467194385 within 1e-12
