// Linkeová: Closed figure-eight of Ferguson cubics (Exercise 2.2)
geo 1
curve k = hermite([(0, 0), (6, 0), (0, 0), (-6, 0), (0, 0)],
  [(9, 9), (0, -9), (-9, 9), (0, -9), (9, 9)])
check len(decompose(k)) == 4
curve form_k_0 = polynomial([(0, 0), (9, 9), (0, -9), (-3, 0)])
check [for t in linspace(0, 1, 6): k(t).x] ~= [for t in linspace(0, 1, 6): form_k_0(t).x] within 9e-12
check [for t in linspace(0, 1, 6): k(t).y] ~= [for t in linspace(0, 1, 6): form_k_0(t).y] within 9e-12
curve form_k_1 = polynomial([(6, 0), (0, -9), (-9, 9), (3, 0)])
check [for t in linspace(0, 1, 6): k(1 + t).x] ~= [for t in linspace(0, 1, 6): form_k_1(t).x] within 9e-12
check [for t in linspace(0, 1, 6): k(1 + t).y] ~= [for t in linspace(0, 1, 6): form_k_1(t).y] within 9e-12
curve form_k_2 = polynomial([(0, 0), (-9, 9), (0, -9), (3, 0)])
check [for t in linspace(0, 1, 6): k(2 + t).x] ~= [for t in linspace(0, 1, 6): form_k_2(t).x] within 9e-12
check [for t in linspace(0, 1, 6): k(2 + t).y] ~= [for t in linspace(0, 1, 6): form_k_2(t).y] within 9e-12
curve form_k_3 = polynomial([(-6, 0), (0, -9), (9, 9), (-3, 0)])
check [for t in linspace(0, 1, 6): k(3 + t).x] ~= [for t in linspace(0, 1, 6): form_k_3(t).x] within 9e-12
check [for t in linspace(0, 1, 6): k(3 + t).y] ~= [for t in linspace(0, 1, 6): form_k_3(t).y] within 9e-12
check continuity(trim(k, 0..1), trim(k, 1..2)).c == 1
check continuity(trim(k, 0..1), trim(k, 1..2)).g >= 2
check continuity(trim(k, 1..2), trim(k, 2..3)).c == 1
check continuity(trim(k, 1..2), trim(k, 2..3)).g == 1
check continuity(trim(k, 2..3), trim(k, 3..4)).c == 1
check continuity(trim(k, 2..3), trim(k, 3..4)).g >= 2
check continuity(trim(k, 3..4), trim(k, 0..1)).c == 1
check continuity(trim(k, 3..4), trim(k, 0..1)).g == 1
