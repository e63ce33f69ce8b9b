// Linkeová: Ferguson/Bezier of Ex 2.5 as a Coons cubic (Exercise 2.16)
geo 1
curve c = bezier((-2, 1), (0, 0), (1, 3), (2, 2))
check to_coons(c).points ~= [(-10, 12, 0), (-1, -3, 0), (2, 6, 0), (5, -9, 0)] within 1.2e-11
curve power_form = polynomial([(-2, 1), (6, -3), (-3, 12), (1, -8)])
check [for t in linspace(0, 1, 6): c(t).x] ~= [for t in linspace(0, 1, 6): power_form(t).x] within 6e-12
check [for t in linspace(0, 1, 6): c(t).y] ~= [for t in linspace(0, 1, 6): power_form(t).y] within 1.2e-11
