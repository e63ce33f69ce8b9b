// Linkeová: Bezier <-> Ferguson (Example 2.5)
geo 1
curve c = bezier((-2, 1), (0, 0), (1, 3), (2, 2))
curve power_form = polynomial([(-2, 1), (6, -3), (-3, 12), (1, -8)])
check [for t in linspace(0, 1, 6): c(t).x] ~= [for t in linspace(0, 1, 6): power_form(t).x] within 6e-12
check [for t in linspace(0, 1, 6): c(t).y] ~= [for t in linspace(0, 1, 6): power_form(t).y] within 1.2e-11
curve power_form_of_derivative = polynomial([(6, -3), (-6, 24), (3, -24)])
check [for t in linspace(0, 1, 5): derivative(c, t).x] ~= [for t in linspace(0, 1, 5): power_form_of_derivative(t).x] within 6e-12
check [for t in linspace(0, 1, 5): derivative(c, t).y] ~= [for t in linspace(0, 1, 5): power_form_of_derivative(t).y] within 2.4e-11
check c(0) ~= (-2, 1, 0) within 2e-12
check derivative(c, 0) ~= (6, -3, 0) within 6e-12
check c(0.5) ~= (3/8, 3/2, 0) within 1.5e-12
check derivative(c, 0.5) ~= (15/4, 3, 0) within 3.75e-12
check c(1) ~= (2, 2, 0) within 2e-12
check derivative(c, 1) ~= (3, -3, 0) within 3e-12
check [c.start, c.end, derivative(c, 0), derivative(c, 1)] ~= [(-2, 1, 0), (2, 2, 0), (6, -3, 0), (3, -3, 0)] within 6e-12
