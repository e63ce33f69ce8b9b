// Linkeová: Clamped cubic as an open Coons B-spline (Exercise 2.27 c))
geo 1
curve c = clamped([(3, 1), (1, 3), (3, 7), (6, 1), (9, 7), (7, 7), (6, 5)])
check to_coons(c).points ~= [(15, -5, 0), (0, 1, 0), (3, 7, 0), (6, 1, 0), (9, 7, 0), (6, 7, 0), (3, -5, 0)] within 1.5e-11
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
