// Linkeová: Clamped cubic as C2 Bezier cubics (Exercise 2.26 c), Fig 2.26)
geo 1
curve c = clamped([(3, 1), (1, 3), (3, 7), (6, 1), (9, 7), (7, 7), (6, 5)])
check len(decompose(c)) == 4
check [for piece in decompose(c): piece.points] ~= [
  [(3, 1, 0), (1, 3, 0), (2, 5, 0), (3, 5, 0)],
  [(3, 5, 0), (4, 5, 0), (5, 3, 0), (6, 3, 0)],
  [(6, 3, 0), (7, 3, 0), (8, 5, 0), (8, 6, 0)],
  [(8, 6, 0), (8, 7, 0), (7, 7, 0), (6, 5, 0)],
] within 8e-12
check c.knots ~= [0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4] within 4e-12
check c(0) ~= (3, 1, 0) within 3e-12
check derivative(c, 0) ~= (-6, 6, 0) within 6e-12
check c(1) ~= (3, 5, 0) within 5e-12
check derivative(c, 1) ~= (3, 0, 0) within 3e-12
check c(2) ~= (6, 3, 0) within 6e-12
check derivative(c, 2) ~= (3, 0, 0) within 3e-12
check c(3) ~= (8, 6, 0) within 8e-12
check derivative(c, 3) ~= (0, 3, 0) within 3e-12
check c(4) ~= (6, 5, 0) within 6e-12
check derivative(c, 4) ~= (-3, -6, 0) within 6e-12
check continuity(trim(c, 0..1), trim(c, 1..4)).c == 2
check continuity(trim(c, 0..2), trim(c, 2..4)).c == 2
check continuity(trim(c, 0..3), trim(c, 3..4)).c == 2
curve power_form_0 = polynomial([(3, 1), (-6, 6), (9, 0), (-3, -2)])
check [for t in linspace(0, 1, 6): c(t).x] ~= [for t in linspace(0, 1, 6): power_form_0(t).x] within 9e-12
check [for t in linspace(0, 1, 6): c(t).y] ~= [for t in linspace(0, 1, 6): power_form_0(t).y] within 6e-12
curve power_form_1 = polynomial([(3, 5), (3, 0), (0, -6), (0, 4)])
check [for t in linspace(0, 1, 6): c(1 + t).x] ~= [for t in linspace(0, 1, 6): power_form_1(t).x] within 3e-12
check [for t in linspace(0, 1, 6): c(1 + t).y] ~= [for t in linspace(0, 1, 6): power_form_1(t).y] within 6e-12
curve power_form_2 = polynomial([(6, 3), (3, 0), (0, 6), (-1, -3)])
check [for t in linspace(0, 1, 6): c(2 + t).x] ~= [for t in linspace(0, 1, 6): power_form_2(t).x] within 6e-12
check [for t in linspace(0, 1, 6): c(2 + t).y] ~= [for t in linspace(0, 1, 6): power_form_2(t).y] within 6e-12
curve power_form_3 = polynomial([(8, 6), (0, 3), (-3, -3), (1, -1)])
check [for t in linspace(0, 1, 6): c(3 + t).x] ~= [for t in linspace(0, 1, 6): power_form_3(t).x] within 8e-12
check [for t in linspace(0, 1, 6): c(3 + t).y] ~= [for t in linspace(0, 1, 6): power_form_3(t).y] within 6e-12
