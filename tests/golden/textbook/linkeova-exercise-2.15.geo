// Linkeová: Coons cubic and its Bezier points (Exercise 2.15)
geo 1
curve c = coons_cubic((12, 6), (6, 0), (0, 0), (0, 12))
curve power_form = polynomial([(6, 1), (-6, -3), (0, 3), (1, 1)])
check [for t in linspace(0, 1, 6): c(t).x] ~= [for t in linspace(0, 1, 6): power_form(t).x] within 6e-12
check [for t in linspace(0, 1, 6): c(t).y] ~= [for t in linspace(0, 1, 6): power_form(t).y] within 3e-12
curve power_form_of_derivative = polynomial([(-6, -3), (0, 6), (3, 3)])
check [for t in linspace(0, 1, 5): derivative(c, t).x] ~= [for t in linspace(0, 1, 5): power_form_of_derivative(t).x] within 6e-12
check [for t in linspace(0, 1, 5): derivative(c, t).y] ~= [for t in linspace(0, 1, 5): power_form_of_derivative(t).y] within 6e-12
check c(0) ~= (6, 1, 0) within 6e-12
check derivative(c, 0) ~= (-6, -3, 0) within 6e-12
check c(0.5) ~= (25/8, 3/8, 0) within 3.12e-12
check derivative(c, 0.5) ~= (-21/4, 3/4, 0) within 5.25e-12
check c(1) ~= (1, 2, 0) within 2e-12
check derivative(c, 1) ~= (-3, 6, 0) within 6e-12
check decompose(c)[0].points ~= [(6, 1, 0), (4, 0, 0), (2, 0, 0), (1, 2, 0)] within 6e-12
