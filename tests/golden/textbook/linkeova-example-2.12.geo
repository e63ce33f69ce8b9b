// Linkeová: Coons = Bezier = Ferguson (Example 2.12)
geo 1
curve c = coons_cubic((-6, 0), (6, 0), (6, 6), (0, 6))
check decompose(c)[0].points ~= [(4, 1, 0), (6, 2, 0), (6, 4, 0), (5, 5, 0)] within 6e-12
check [c.start, c.end, derivative(c, 0), derivative(c, 1)] ~= [(4, 1, 0), (5, 5, 0), (6, 3, 0), (-3, 3, 0)] within 6e-12
curve power_form = polynomial([(4, 1), (6, 3), (-6, 3), (1, -2)])
check [for t in linspace(0, 1, 6): c(t).x] ~= [for t in linspace(0, 1, 6): power_form(t).x] within 6e-12
check [for t in linspace(0, 1, 6): c(t).y] ~= [for t in linspace(0, 1, 6): power_form(t).y] within 3e-12
