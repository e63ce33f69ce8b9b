// Linkeová: Coons cubic (Example 2.11)
geo 1
curve c = coons_cubic((-6, 0), (6, 0), (6, 6), (0, 6))
curve power_form = polynomial([(4, 1), (6, 3), (-6, 3), (1, -2)])
check [for t in linspace(0, 1, 6): c(t).x] ~= [for t in linspace(0, 1, 6): power_form(t).x] within 6e-12
check [for t in linspace(0, 1, 6): c(t).y] ~= [for t in linspace(0, 1, 6): power_form(t).y] within 3e-12
curve power_form_of_derivative = polynomial([(6, 3), (-12, 6), (3, -6)])
check [for t in linspace(0, 1, 5): derivative(c, t).x] ~= [for t in linspace(0, 1, 5): power_form_of_derivative(t).x] within 1.2e-11
check [for t in linspace(0, 1, 5): derivative(c, t).y] ~= [for t in linspace(0, 1, 5): power_form_of_derivative(t).y] within 6e-12
check c(0) ~= (4, 1, 0) within 4e-12
check derivative(c, 0) ~= (6, 3, 0) within 6e-12
check c(0.25) ~= (329/64, 61/32, 0) within 5.14e-12
check derivative(c, 0.25) ~= (51/16, 33/8, 0) within 4.12e-12
check c(0.5) ~= (45/8, 3, 0) within 5.62e-12
check derivative(c, 0.5) ~= (3/4, 9/2, 0) within 4.5e-12
check c(0.75) ~= (355/64, 131/32, 0) within 5.55e-12
check derivative(c, 0.75) ~= (-21/16, 33/8, 0) within 4.12e-12
check c(1) ~= (5, 5, 0) within 5e-12
check derivative(c, 1) ~= (-3, 3, 0) within 3e-12
