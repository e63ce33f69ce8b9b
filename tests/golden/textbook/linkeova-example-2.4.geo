// Linkeová: Bezier cubic (Example 2.4, (2.22)-(2.23))
geo 1
curve c = bezier((2, 3), (4, 2), (0, 0), (-1, 1))
curve power_form = polynomial([(2, 3), (6, -3), (-18, -3), (9, 4)])
check [for t in linspace(0, 1, 6): c(t).x] ~= [for t in linspace(0, 1, 6): power_form(t).x] within 1.8e-11
check [for t in linspace(0, 1, 6): c(t).y] ~= [for t in linspace(0, 1, 6): power_form(t).y] within 4e-12
curve power_form_of_derivative = polynomial([(6, -3), (-36, -6), (27, 12)])
check [for t in linspace(0, 1, 5): derivative(c, t).x] ~= [for t in linspace(0, 1, 5): power_form_of_derivative(t).x] within 3.6e-11
check [for t in linspace(0, 1, 5): derivative(c, t).y] ~= [for t in linspace(0, 1, 5): power_form_of_derivative(t).y] within 1.2e-11
check c(0) ~= (2, 3, 0) within 3e-12
check derivative(c, 0) ~= (6, -3, 0) within 6e-12
check c(0.25) ~= (161/64, 17/8, 0) within 2.52e-12
check derivative(c, 0.25) ~= (-21/16, -15/4, 0) within 3.75e-12
check c(0.5) ~= (13/8, 5/4, 0) within 1.62e-12
check derivative(c, 0.5) ~= (-21/4, -3, 0) within 5.25e-12
check c(0.75) ~= (11/64, 3/4, 0) within 1e-12
check derivative(c, 0.75) ~= (-93/16, -3/4, 0) within 5.81e-12
check c(1) ~= (-1, 1, 0) within 1e-12
check derivative(c, 1) ~= (-3, 3, 0) within 3e-12
check de_casteljau(c, 0.25) ~= [
  [(2, 3, 0), (4, 2, 0), (0, 0, 0), (-1, 1, 0)],
  [(5/2, 11/4, 0), (3, 3/2, 0), (-1/4, 1/4, 0)],
  [(21/8, 39/16, 0), (35/16, 19/16, 0)],
  [(161/64, 17/8, 0)],
] within 4e-12
check de_casteljau(c, 0.5) ~= [
  [(2, 3, 0), (4, 2, 0), (0, 0, 0), (-1, 1, 0)],
  [(3, 5/2, 0), (2, 1, 0), (-1/2, 1/2, 0)],
  [(5/2, 7/4, 0), (3/4, 3/4, 0)],
  [(13/8, 5/4, 0)],
] within 4e-12
check de_casteljau(c, 0.75) ~= [
  [(2, 3, 0), (4, 2, 0), (0, 0, 0), (-1, 1, 0)],
  [(7/2, 9/4, 0), (1, 1/2, 0), (-3/4, 3/4, 0)],
  [(13/8, 15/16, 0), (-5/16, 11/16, 0)],
  [(11/64, 3/4, 0)],
] within 4e-12
