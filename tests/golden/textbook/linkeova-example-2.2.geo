// Linkeová: '@' sign: two piecewise Ferguson curves, continuity (Example 2.2 + remark, Fig 2.3)
geo 1
curve k_star = hermite([(47, 46), (22, 34), (31, 20), (47, 46)],
  [(-54, 21), (-3, -24), (18, -3), (6, 72)])
curve k = hermite([(47, 46), (58, 20), (64, 35), (55, 56), (26, 61), (9, 28), (47, 7)],
  [(3, -78), (12, 6), (0, 21), (-21, 18), (-30, -15), (3, -42), (81, 21)])
check k_star(1/2) ~= (225/8, 365/8, 0) within 4.56e-11
check derivative(k_star, 1/2) ~= (-93/4, -69/4, 0) within 2.32e-11
check k_star(3/2) ~= (191/8, 195/8, 0) within 2.44e-11
check derivative(k_star, 3/2) ~= (39/4, -57/4, 0) within 1.42e-11
check k_star(5/2) ~= (81/2, 189/8, 0) within 4.05e-11
check derivative(k_star, 5/2) ~= (18, 87/4, 0) within 2.17e-11
check continuity(trim(k_star, 0..1), trim(k_star, 1..2)).c == 2
check continuity(trim(k_star, 1..2), trim(k_star, 2..3)).c == 2
check k(1/2) ~= (411/8, 45/2, 0) within 5.14e-11
check derivative(k, 1/2) ~= (51/4, -21, 0) within 2.1e-11
check k(3/2) ~= (125/2, 205/8, 0) within 6.25e-11
check derivative(k, 3/2) ~= (6, 63/4, 0) within 1.57e-11
check k(5/2) ~= (497/8, 367/8, 0) within 6.21e-11
check derivative(k, 5/2) ~= (-33/4, 87/4, 0) within 2.17e-11
check k(7/2) ~= (333/8, 501/8, 0) within 6.26e-11
check derivative(k, 7/2) ~= (-123/4, 27/4, 0) within 3.07e-11
check k(9/2) ~= (107/8, 383/8, 0) within 4.79e-11
check derivative(k, 9/2) ~= (-75/4, -141/4, 0) within 3.52e-11
check k(11/2) ~= (73/4, 77/8, 0) within 1.82e-11
check derivative(k, 11/2) ~= (36, -105/4, 0) within 3.6e-11
check continuity(trim(k, 0..1), trim(k, 1..2)).c == 2
check continuity(trim(k, 1..2), trim(k, 2..3)).c == 2
check continuity(trim(k, 2..3), trim(k, 3..4)).c == 2
check continuity(trim(k, 3..4), trim(k, 4..5)).c == 2
check continuity(trim(k, 4..5), trim(k, 5..6)).c == 2
check continuity(trim(k_star, 2..3), trim(k_star, 0..1)).c == 0
check continuity(trim(k_star, 2..3), trim(k_star, 0..1)).g == 0
