// Linkeová: Bezier quadratic (Example 2.3, (2.20)-(2.21))
geo 1
curve c = bezier((2, 0), (4, 1), (3, 2))
curve power_form = polynomial([(2, 0), (4, 2), (-3, 0)])
check [for t in linspace(0, 1, 5): c(t).x] ~= [for t in linspace(0, 1, 5): power_form(t).x] within 4e-12
check [for t in linspace(0, 1, 5): c(t).y] ~= [for t in linspace(0, 1, 5): power_form(t).y] within 2e-12
curve power_form_of_derivative = polynomial([(4, 2), (-6, 0)])
check [for t in linspace(0, 1, 4): derivative(c, t).x] ~= [for t in linspace(0, 1, 4): power_form_of_derivative(t).x] within 6e-12
check [for t in linspace(0, 1, 4): derivative(c, t).y] ~= [for t in linspace(0, 1, 4): power_form_of_derivative(t).y] within 2e-12
check c(0) ~= (2, 0, 0) within 2e-12
check derivative(c, 0) ~= (4, 2, 0) within 4e-12
check c(0.25) ~= (45/16, 1/2, 0) within 2.81e-12
check derivative(c, 0.25) ~= (5/2, 2, 0) within 2.5e-12
check c(0.5) ~= (13/4, 1, 0) within 3.25e-12
check derivative(c, 0.5) ~= (1, 2, 0) within 2e-12
check c(0.75) ~= (53/16, 3/2, 0) within 3.31e-12
check derivative(c, 0.75) ~= (-1/2, 2, 0) within 2e-12
check c(1) ~= (3, 2, 0) within 3e-12
check derivative(c, 1) ~= (-2, 2, 0) within 2e-12
check de_casteljau(c, 0.25) ~= [[(2, 0, 0), (4, 1, 0), (3, 2, 0)], [(5/2, 1/4, 0), (15/4, 5/4, 0)], [(45/16, 1/2, 0)]] within 4e-12
check de_casteljau(c, 0.5) ~= [[(2, 0, 0), (4, 1, 0), (3, 2, 0)], [(3, 1/2, 0), (7/2, 3/2, 0)], [(13/4, 1, 0)]] within 4e-12
check de_casteljau(c, 0.75) ~= [[(2, 0, 0), (4, 1, 0), (3, 2, 0)], [(7/2, 3/4, 0), (13/4, 7/4, 0)], [(53/16, 3/2, 0)]] within 4e-12
