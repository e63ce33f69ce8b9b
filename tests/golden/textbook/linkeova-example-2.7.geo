// Linkeová: de Casteljau, degree 6, t=1/2 (Example 2.7)
geo 1
curve c = bezier([(0, 2), (7, 9), (17, 9), (20, 4), (16, 0), (10, 0), (6, 4)])
curve power_form = polynomial([(0, 2), (42, 42), (45, -105), (-200, 40), (150, 60), (-30, -42), (-1, 7)])
check [for t in linspace(0, 1, 9): c(t).x] ~= [for t in linspace(0, 1, 9): power_form(t).x] within 2e-12
check [for t in linspace(0, 1, 9): c(t).y] ~= [for t in linspace(0, 1, 9): power_form(t).y] within 1.05e-12
curve power_form_of_derivative = polynomial([(42, 42), (90, -210), (-600, 120), (600, 240), (-150, -210), (-6, 42)])
check [for t in linspace(0, 1, 8): derivative(c, t).x] ~= [for t in linspace(0, 1, 8): power_form_of_derivative(t).x] within 6e-12
check [for t in linspace(0, 1, 8): derivative(c, t).y] ~= [for t in linspace(0, 1, 8): power_form_of_derivative(t).y] within 2.4e-12
check c(0) ~= (0, 2, 0) within 2e-12
check derivative(c, 0) ~= (42, 42, 0) within 4.2e-11
check c(0.5) ~= (1003/64, 275/64, 0) within 1.57e-11
check derivative(c, 0.5) ~= (39/16, -237/16, 0) within 1.48e-11
check c(1) ~= (6, 4, 0) within 6e-12
check derivative(c, 1) ~= (-24, 24, 0) within 2.4e-11
check de_casteljau(c, 0.5) ~= [
  [(0, 2, 0), (7, 9, 0), (17, 9, 0), (20, 4, 0), (16, 0, 0), (10, 0, 0), (6, 4, 0)],
  [(7/2, 11/2, 0), (12, 9, 0), (37/2, 13/2, 0), (18, 2, 0), (13, 0, 0), (8, 2, 0)],
  [(31/4, 29/4, 0), (61/4, 31/4, 0), (73/4, 17/4, 0), (31/2, 1, 0), (21/2, 1, 0)],
  [(23/2, 15/2, 0), (67/4, 6, 0), (135/8, 21/8, 0), (13, 1, 0)],
  [(113/8, 27/4, 0), (269/16, 69/16, 0), (239/16, 29/16, 0)],
  [(495/32, 177/32, 0), (127/8, 49/16, 0)],
  [(1003/64, 275/64, 0)],
] within 2e-11
check c.degree == 6
