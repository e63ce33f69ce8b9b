// Linkeová: Bezier quadratic (Exercise 2.4 d))
geo 1
curve c = bezier((0, 0), (-1, -1), (0, -1))
curve power_form = polynomial([(0, 0), (-2, -2), (2, 1)])
check [for t in linspace(0, 1, 5): c(t).x] ~= [for t in linspace(0, 1, 5): power_form(t).x] within 2e-12
check [for t in linspace(0, 1, 5): c(t).y] ~= [for t in linspace(0, 1, 5): power_form(t).y] within 2e-12
curve power_form_of_derivative = polynomial([(-2, -2), (4, 2)])
check [for t in linspace(0, 1, 4): derivative(c, t).x] ~= [for t in linspace(0, 1, 4): power_form_of_derivative(t).x] within 4e-12
check [for t in linspace(0, 1, 4): derivative(c, t).y] ~= [for t in linspace(0, 1, 4): power_form_of_derivative(t).y] within 2e-12
check c(0) ~= (0, 0, 0) within 1e-12
check derivative(c, 0) ~= (-2, -2, 0) within 2e-12
check c(0.5) ~= (-1/2, -3/4, 0) within 1e-12
check derivative(c, 0.5) ~= (0, -1, 0) within 1e-12
check c(1) ~= (0, -1, 0) within 1e-12
check derivative(c, 1) ~= (2, 0, 0) within 2e-12
check de_casteljau(c, 0.5) ~= [[(0, 0, 0), (-1, -1, 0), (0, -1, 0)], [(-1/2, -1/2, 0), (-1/2, -1, 0)], [(-1/2, -3/4, 0)]] within 1e-12
