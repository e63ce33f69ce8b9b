// Linkeová: Clamped cubic as an open Coons B-spline (Exercise 2.27 b))
geo 1
curve c = clamped([(4, 1), (1, 3), (1, 7), (7, 7), (7, 3), (10, 1)])
check to_coons(c).points ~= [(19, -5, 0), (1, 1, 0), (1, 7, 0), (7, 7, 0), (7, 1, 0), (25, -5, 0)] within 2.5e-11
curve power_form_0 = polynomial([(4, 1), (-9, 6), (9, 0), (-2, -1)])
check [for t in linspace(0, 1, 6): c(t).x] ~= [for t in linspace(0, 1, 6): power_form_0(t).x] within 9e-12
check [for t in linspace(0, 1, 6): c(t).y] ~= [for t in linspace(0, 1, 6): power_form_0(t).y] within 6e-12
curve power_form_1 = polynomial([(2, 6), (3, 3), (3, -3), (-2, 0)])
check [for t in linspace(0, 1, 6): c(1 + t).x] ~= [for t in linspace(0, 1, 6): power_form_1(t).x] within 3e-12
check [for t in linspace(0, 1, 6): c(1 + t).y] ~= [for t in linspace(0, 1, 6): power_form_1(t).y] within 6e-12
curve power_form_2 = polynomial([(6, 6), (3, -3), (-3, -3), (4, 1)])
check [for t in linspace(0, 1, 6): c(2 + t).x] ~= [for t in linspace(0, 1, 6): power_form_2(t).x] within 6e-12
check [for t in linspace(0, 1, 6): c(2 + t).y] ~= [for t in linspace(0, 1, 6): power_form_2(t).y] within 6e-12
