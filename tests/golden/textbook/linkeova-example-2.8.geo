// Linkeová: Closing a Bezier quadratic C1 with two more quadratics (Example 2.8)
geo 1
curve p = bezier((-1, 1), (0, 0), (1, 1))
curve r = continue_bezier(p, 1, [(0, 2)])
curve s = continue_bezier(r, 1, [(-1, 1)])
check r.points ~= [(1, 1, 0), (2, 2, 0), (0, 2, 0)] within 2e-12
check s.points ~= [(0, 2, 0), (-2, 2, 0), (-1, 1, 0)] within 2e-12
curve power_form_p = polynomial([(-1, 1), (2, -2), (0, 2)])
check [for t in linspace(0, 1, 5): p(t).x] ~= [for t in linspace(0, 1, 5): power_form_p(t).x] within 2e-12
check [for t in linspace(0, 1, 5): p(t).y] ~= [for t in linspace(0, 1, 5): power_form_p(t).y] within 2e-12
curve power_form_r = polynomial([(1, 1), (2, 2), (-3, -1)])
check [for t in linspace(0, 1, 5): r(t).x] ~= [for t in linspace(0, 1, 5): power_form_r(t).x] within 3e-12
check [for t in linspace(0, 1, 5): r(t).y] ~= [for t in linspace(0, 1, 5): power_form_r(t).y] within 2e-12
curve power_form_s = polynomial([(0, 2), (-4, 0), (3, -1)])
check [for t in linspace(0, 1, 5): s(t).x] ~= [for t in linspace(0, 1, 5): power_form_s(t).x] within 4e-12
check [for t in linspace(0, 1, 5): s(t).y] ~= [for t in linspace(0, 1, 5): power_form_s(t).y] within 2e-12
check continuity(p, r).c == 1
check continuity(p, r).g >= 2
check continuity(r, s).c == 1
check continuity(r, s).g >= 2
check continuity(s, p).c == 1
check continuity(s, p).g >= 2
