// Linkeová: Ferguson cubic A=(0,0) B=(2,0) (Exercise 2.1 a))
geo 1
curve c = hermite([(0, 0), (2, 0)], [(0, 1), (0, -1)])
curve power_form = polynomial([(0, 0), (0, 1), (6, -1), (-4, 0)])
check [for t in linspace(0, 1, 6): c(t).x] ~= [for t in linspace(0, 1, 6): power_form(t).x] within 6e-12
check [for t in linspace(0, 1, 6): c(t).y] ~= [for t in linspace(0, 1, 6): power_form(t).y] within 1e-12
curve power_form_of_derivative = polynomial([(0, 1), (12, -2), (-12, 0)])
check [for t in linspace(0, 1, 5): derivative(c, t).x] ~= [for t in linspace(0, 1, 5): power_form_of_derivative(t).x] within 1.2e-11
check [for t in linspace(0, 1, 5): derivative(c, t).y] ~= [for t in linspace(0, 1, 5): power_form_of_derivative(t).y] within 2e-12
check c(0) ~= (0, 0, 0) within 1e-12
check derivative(c, 0) ~= (0, 1, 0) within 1e-12
check c(0.5) ~= (1, 1/4, 0) within 1e-12
check derivative(c, 0.5) ~= (3, 0, 0) within 3e-12
check c(1) ~= (2, 0, 0) within 2e-12
check derivative(c, 1) ~= (0, -1, 0) within 1e-12
check decompose(c)[0].points ~= [(0, 0, 0), (0, 1/3, 0), (2, 1/3, 0), (2, 0, 0)] within 2e-12
