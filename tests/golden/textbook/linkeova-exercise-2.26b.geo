// Linkeová: Clamped cubic as C2 Bezier cubics (Exercise 2.26 b), Fig 2.26)
geo 1
curve c = clamped([(4, 1), (1, 3), (1, 7), (7, 7), (7, 3), (10, 1)])
check len(decompose(c)) == 3
check [for piece in decompose(c): piece.points] ~= [
  [(4, 1, 0), (1, 3, 0), (1, 5, 0), (2, 6, 0)],
  [(2, 6, 0), (3, 7, 0), (5, 7, 0), (6, 6, 0)],
  [(6, 6, 0), (7, 5, 0), (7, 3, 0), (10, 1, 0)],
] within 1e-11
check c.knots ~= [0, 0, 0, 0, 1, 2, 3, 3, 3, 3] within 3e-12
check c(0) ~= (4, 1, 0) within 4e-12
check derivative(c, 0) ~= (-9, 6, 0) within 9e-12
check c(1) ~= (2, 6, 0) within 6e-12
check derivative(c, 1) ~= (3, 3, 0) within 3e-12
check c(2) ~= (6, 6, 0) within 6e-12
check derivative(c, 2) ~= (3, -3, 0) within 3e-12
check c(3) ~= (10, 1, 0) within 1e-11
check derivative(c, 3) ~= (9, -6, 0) within 9e-12
check continuity(trim(c, 0..1), trim(c, 1..3)).c == 2
check continuity(trim(c, 0..2), trim(c, 2..3)).c == 2
curve power_form_0 = polynomial([(4, 1), (-9, 6), (9, 0), (-2, -1)])
check [for t in linspace(0, 1, 6): c(t).x] ~= [for t in linspace(0, 1, 6): power_form_0(t).x] within 9e-12
check [for t in linspace(0, 1, 6): c(t).y] ~= [for t in linspace(0, 1, 6): power_form_0(t).y] within 6e-12
curve power_form_1 = polynomial([(2, 6), (3, 3), (3, -3), (-2, 0)])
check [for t in linspace(0, 1, 6): c(1 + t).x] ~= [for t in linspace(0, 1, 6): power_form_1(t).x] within 3e-12
check [for t in linspace(0, 1, 6): c(1 + t).y] ~= [for t in linspace(0, 1, 6): power_form_1(t).y] within 6e-12
curve power_form_2 = polynomial([(6, 6), (3, -3), (-3, -3), (4, 1)])
check [for t in linspace(0, 1, 6): c(2 + t).x] ~= [for t in linspace(0, 1, 6): power_form_2(t).x] within 6e-12
check [for t in linspace(0, 1, 6): c(2 + t).y] ~= [for t in linspace(0, 1, 6): power_form_2(t).y] within 6e-12
