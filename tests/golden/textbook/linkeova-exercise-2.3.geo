// Linkeová: '@' sign: vector equations of all segments (Exercise 2.3)
geo 1
curve k_star = hermite([(47, 46), (22, 34), (31, 20), (47, 46)],
  [(-54, 21), (-3, -24), (18, -3), (6, 72)])
curve k = hermite([(47, 46), (58, 20), (64, 35), (55, 56), (26, 61), (9, 28), (47, 7)],
  [(3, -78), (12, 6), (0, 21), (-21, 18), (-30, -15), (3, -42), (81, 21)])
curve form_k_star_0 = polynomial([(47, 46), (-54, 21), (36, -54), (-7, 21)])
check [for t in linspace(0, 1, 6): k_star(t).x] ~= [for t in linspace(0, 1, 6): form_k_star_0(t).x] within 5.4e-11
check [for t in linspace(0, 1, 6): k_star(t).y] ~= [for t in linspace(0, 1, 6): form_k_star_0(t).y] within 5.4e-11
curve form_k_star_1 = polynomial([(22, 34), (-3, -24), (15, 9), (-3, 1)])
check [for t in linspace(0, 1, 6): k_star(1 + t).x] ~= [for t in linspace(0, 1, 6): form_k_star_1(t).x] within 2.2e-11
check [for t in linspace(0, 1, 6): k_star(1 + t).y] ~= [for t in linspace(0, 1, 6): form_k_star_1(t).y] within 3.4e-11
curve form_k_star_2 = polynomial([(31, 20), (18, -3), (6, 12), (-8, 17)])
check [for t in linspace(0, 1, 6): k_star(2 + t).x] ~= [for t in linspace(0, 1, 6): form_k_star_2(t).x] within 3.1e-11
check [for t in linspace(0, 1, 6): k_star(2 + t).y] ~= [for t in linspace(0, 1, 6): form_k_star_2(t).y] within 2e-11
curve form_k_0 = polynomial([(47, 46), (3, -78), (15, 72), (-7, -20)])
check [for t in linspace(0, 1, 6): k(t).x] ~= [for t in linspace(0, 1, 6): form_k_0(t).x] within 4.7e-11
check [for t in linspace(0, 1, 6): k(t).y] ~= [for t in linspace(0, 1, 6): form_k_0(t).y] within 7.8e-11
curve form_k_1 = polynomial([(58, 20), (12, 6), (-6, 12), (0, -3)])
check [for t in linspace(0, 1, 6): k(1 + t).x] ~= [for t in linspace(0, 1, 6): form_k_1(t).x] within 5.8e-11
check [for t in linspace(0, 1, 6): k(1 + t).y] ~= [for t in linspace(0, 1, 6): form_k_1(t).y] within 2e-11
curve form_k_2 = polynomial([(64, 35), (0, 21), (-6, 3), (-3, -3)])
check [for t in linspace(0, 1, 6): k(2 + t).x] ~= [for t in linspace(0, 1, 6): form_k_2(t).x] within 6.4e-11
check [for t in linspace(0, 1, 6): k(2 + t).y] ~= [for t in linspace(0, 1, 6): form_k_2(t).y] within 3.5e-11
curve form_k_3 = polynomial([(55, 56), (-21, 18), (-15, -6), (7, -7)])
check [for t in linspace(0, 1, 6): k(3 + t).x] ~= [for t in linspace(0, 1, 6): form_k_3(t).x] within 5.5e-11
check [for t in linspace(0, 1, 6): k(3 + t).y] ~= [for t in linspace(0, 1, 6): form_k_3(t).y] within 5.6e-11
curve form_k_4 = polynomial([(26, 61), (-30, -15), (6, -27), (7, 9)])
check [for t in linspace(0, 1, 6): k(4 + t).x] ~= [for t in linspace(0, 1, 6): form_k_4(t).x] within 3e-11
check [for t in linspace(0, 1, 6): k(4 + t).y] ~= [for t in linspace(0, 1, 6): form_k_4(t).y] within 6.1e-11
curve form_k_5 = polynomial([(9, 28), (3, -42), (27, 0), (8, 21)])
check [for t in linspace(0, 1, 6): k(5 + t).x] ~= [for t in linspace(0, 1, 6): form_k_5(t).x] within 2.7e-11
check [for t in linspace(0, 1, 6): k(5 + t).y] ~= [for t in linspace(0, 1, 6): form_k_5(t).y] within 4.2e-11
