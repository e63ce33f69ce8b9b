// Linkeová: Clamped cubic as an open Coons B-spline (Exercise 2.27 d))
geo 1
curve c = clamped([(4, 5), (3, 7), (1, 7), (4, 1), (7, 7), (10, 1), (8, 1), (7, 3)])
check to_coons(c).points ~= [(7, -5, 0), (4, 7, 0), (1, 7, 0), (4, 1, 0), (7, 7, 0), (10, 1, 0), (7, 1, 0), (4, 13, 0)] within 1.3e-11
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
