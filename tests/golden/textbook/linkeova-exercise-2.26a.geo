// Linkeová: Clamped cubic as C2 Bezier cubics (Exercise 2.26 a), Fig 2.26)
geo 1
curve c = clamped([(1, 1), (3, 1), (5, 7), (7, 1), (9, 4)])
check len(decompose(c)) == 2
check [for piece in decompose(c): piece.points] ~= [[(1, 1, 0), (3, 1, 0), (4, 4, 0), (5, 4, 0)], [(5, 4, 0), (6, 4, 0), (7, 1, 0), (9, 4, 0)]] within 9e-12
check c.knots ~= [0, 0, 0, 0, 1, 2, 2, 2, 2] within 2e-12
check c(0) ~= (1, 1, 0) within 1e-12
check derivative(c, 0) ~= (6, 0, 0) within 6e-12
check c(1) ~= (5, 4, 0) within 5e-12
check derivative(c, 1) ~= (3, 0, 0) within 3e-12
check c(2) ~= (9, 4, 0) within 9e-12
check derivative(c, 2) ~= (6, 9, 0) within 9e-12
check continuity(trim(c, 0..1), trim(c, 1..2)).c == 2
curve power_form_0 = polynomial([(1, 1), (6, 0), (-3, 9), (1, -6)])
check [for t in linspace(0, 1, 6): c(t).x] ~= [for t in linspace(0, 1, 6): power_form_0(t).x] within 6e-12
check [for t in linspace(0, 1, 6): c(t).y] ~= [for t in linspace(0, 1, 6): power_form_0(t).y] within 9e-12
curve power_form_1 = polynomial([(5, 4), (3, 0), (0, -9), (1, 9)])
check [for t in linspace(0, 1, 6): c(1 + t).x] ~= [for t in linspace(0, 1, 6): power_form_1(t).x] within 5e-12
check [for t in linspace(0, 1, 6): c(1 + t).y] ~= [for t in linspace(0, 1, 6): power_form_1(t).y] within 9e-12
