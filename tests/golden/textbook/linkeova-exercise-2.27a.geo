// Linkeová: Clamped cubic as an open Coons B-spline (Exercise 2.27 a))
geo 1
curve c = clamped([(1, 1), (3, 1), (5, 7), (7, 1), (9, 4)])
check to_coons(c).points ~= [(-7, 7, 0), (2, -2, 0), (5, 7, 0), (8, -2, 0), (17, 25, 0)] within 2.5e-11
curve power_form_0 = polynomial([(1, 1), (6, 0), (-3, 9), (1, -6)])
check [for t in linspace(0, 1, 6): c(t).x] ~= [for t in linspace(0, 1, 6): power_form_0(t).x] within 6e-12
check [for t in linspace(0, 1, 6): c(t).y] ~= [for t in linspace(0, 1, 6): power_form_0(t).y] within 9e-12
curve power_form_1 = polynomial([(5, 4), (3, 0), (0, -9), (1, 9)])
check [for t in linspace(0, 1, 6): c(1 + t).x] ~= [for t in linspace(0, 1, 6): power_form_1(t).x] within 5e-12
check [for t in linspace(0, 1, 6): c(1 + t).y] ~= [for t in linspace(0, 1, 6): power_form_1(t).y] within 9e-12
