// Linkeová: Clamped cubic as C2 Bezier cubics (Exercise 2.26 d), Fig 2.26)
geo 1
curve c = clamped([(4, 5), (3, 7), (1, 7), (4, 1), (7, 7), (10, 1), (8, 1), (7, 3)])
check len(decompose(c)) == 5
check [for piece in decompose(c): piece.points] ~= [
  [(4, 5, 0), (3, 7, 0), (2, 7, 0), (2, 6, 0)],
  [(2, 6, 0), (2, 5, 0), (3, 3, 0), (4, 3, 0)],
  [(4, 3, 0), (5, 3, 0), (6, 5, 0), (7, 5, 0)],
  [(7, 5, 0), (8, 5, 0), (9, 3, 0), (9, 2, 0)],
  [(9, 2, 0), (9, 1, 0), (8, 1, 0), (7, 3, 0)],
] within 9e-12
check c.knots ~= [0, 0, 0, 0, 1, 2, 3, 4, 5, 5, 5, 5] within 5e-12
check c(0) ~= (4, 5, 0) within 5e-12
check derivative(c, 0) ~= (-3, 6, 0) within 6e-12
check c(1) ~= (2, 6, 0) within 6e-12
check derivative(c, 1) ~= (0, -3, 0) within 3e-12
check c(2) ~= (4, 3, 0) within 4e-12
check derivative(c, 2) ~= (3, 0, 0) within 3e-12
check c(3) ~= (7, 5, 0) within 7e-12
check derivative(c, 3) ~= (3, 0, 0) within 3e-12
check c(4) ~= (9, 2, 0) within 9e-12
check derivative(c, 4) ~= (0, -3, 0) within 3e-12
check c(5) ~= (7, 3, 0) within 7e-12
check derivative(c, 5) ~= (-3, 6, 0) within 6e-12
check continuity(trim(c, 0..1), trim(c, 1..5)).c == 2
check continuity(trim(c, 0..2), trim(c, 2..5)).c == 2
check continuity(trim(c, 0..3), trim(c, 3..5)).c == 2
check continuity(trim(c, 0..4), trim(c, 4..5)).c == 2
curve power_form_0 = polynomial([(4, 5), (-3, 6), (0, -6), (1, 1)])
check [for t in linspace(0, 1, 6): c(t).x] ~= [for t in linspace(0, 1, 6): power_form_0(t).x] within 4e-12
check [for t in linspace(0, 1, 6): c(t).y] ~= [for t in linspace(0, 1, 6): power_form_0(t).y] within 6e-12
curve power_form_1 = polynomial([(2, 6), (0, -3), (3, -3), (-1, 3)])
check [for t in linspace(0, 1, 6): c(1 + t).x] ~= [for t in linspace(0, 1, 6): power_form_1(t).x] within 3e-12
check [for t in linspace(0, 1, 6): c(1 + t).y] ~= [for t in linspace(0, 1, 6): power_form_1(t).y] within 6e-12
curve power_form_2 = polynomial([(4, 3), (3, 0), (0, 6), (0, -4)])
check [for t in linspace(0, 1, 6): c(2 + t).x] ~= [for t in linspace(0, 1, 6): power_form_2(t).x] within 4e-12
check [for t in linspace(0, 1, 6): c(2 + t).y] ~= [for t in linspace(0, 1, 6): power_form_2(t).y] within 6e-12
curve power_form_3 = polynomial([(7, 5), (3, 0), (0, -6), (-1, 3)])
check [for t in linspace(0, 1, 6): c(3 + t).x] ~= [for t in linspace(0, 1, 6): power_form_3(t).x] within 7e-12
check [for t in linspace(0, 1, 6): c(3 + t).y] ~= [for t in linspace(0, 1, 6): power_form_3(t).y] within 6e-12
curve power_form_4 = polynomial([(9, 2), (0, -3), (-3, 3), (1, 1)])
check [for t in linspace(0, 1, 6): c(4 + t).x] ~= [for t in linspace(0, 1, 6): power_form_4(t).x] within 9e-12
check [for t in linspace(0, 1, 6): c(4 + t).y] ~= [for t in linspace(0, 1, 6): power_form_4(t).y] within 3e-12
