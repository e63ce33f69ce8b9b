// Linkeová: Ferguson cubic (Example 2.1, (2.3)-(2.6))
geo 1
curve c = hermite([(1, 0), (4, 2)], [(-1, 3), (2, -2)])
curve power_form = polynomial([(1, 0), (-1, 3), (9, 2), (-5, -3)])
check [for t in linspace(0, 1, 6): c(t).x] ~= [for t in linspace(0, 1, 6): power_form(t).x] within 9e-12
check [for t in linspace(0, 1, 6): c(t).y] ~= [for t in linspace(0, 1, 6): power_form(t).y] within 3e-12
curve power_form_of_derivative = polynomial([(-1, 3), (18, 4), (-15, -9)])
check [for t in linspace(0, 1, 5): derivative(c, t).x] ~= [for t in linspace(0, 1, 5): power_form_of_derivative(t).x] within 1.8e-11
check [for t in linspace(0, 1, 5): derivative(c, t).y] ~= [for t in linspace(0, 1, 5): power_form_of_derivative(t).y] within 9e-12
check c(0) ~= (1, 0, 0) within 1e-12
check derivative(c, 0) ~= (-1, 3, 0) within 3e-12
check c(0.25) ~= (79/64, 53/64, 0) within 1.23e-12
check derivative(c, 0.25) ~= (41/16, 55/16, 0) within 3.44e-12
check c(0.5) ~= (17/8, 13/8, 0) within 2.12e-12
check derivative(c, 0.5) ~= (17/4, 11/4, 0) within 4.25e-12
check c(0.75) ~= (205/64, 135/64, 0) within 3.2e-12
check derivative(c, 0.75) ~= (65/16, 15/16, 0) within 4.06e-12
check c(1) ~= (4, 2, 0) within 4e-12
check derivative(c, 1) ~= (2, -2, 0) within 2e-12
check decompose(c)[0].points ~= [(1, 0, 0), (2/3, 1, 0), (10/3, 8/3, 0), (4, 2, 0)] within 4e-12
