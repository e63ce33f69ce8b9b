// Linkeová: C2 joining on both sides of a Bezier cubic (Example 2.10)
geo 1
curve p = bezier((4, 1), (5, 0), (7, 0), (8, 2))
curve r = reversed(continue_bezier(reversed(p), 2, [(0, 4)]))
curve s = continue_bezier(p, 2, [(0, 4)])
check r.points ~= [(0, 4, 0), (3, 4, 0), (3, 2, 0), (4, 1, 0)] within 4e-12
check s.points ~= [(8, 2, 0), (9, 4, 0), (9, 8, 0), (0, 4, 0)] within 9e-12
curve power_form_r = polynomial([(0, 4), (9, 0), (-9, -6), (4, 3)])
check [for t in linspace(0, 1, 6): r(t).x] ~= [for t in linspace(0, 1, 6): power_form_r(t).x] within 9e-12
check [for t in linspace(0, 1, 6): r(t).y] ~= [for t in linspace(0, 1, 6): power_form_r(t).y] within 6e-12
curve power_form_p = polynomial([(4, 1), (3, -3), (3, 3), (-2, 1)])
check [for t in linspace(0, 1, 6): p(t).x] ~= [for t in linspace(0, 1, 6): power_form_p(t).x] within 4e-12
check [for t in linspace(0, 1, 6): p(t).y] ~= [for t in linspace(0, 1, 6): power_form_p(t).y] within 3e-12
curve power_form_s = polynomial([(8, 2), (3, 6), (-3, 6), (-8, -10)])
check [for t in linspace(0, 1, 6): s(t).x] ~= [for t in linspace(0, 1, 6): power_form_s(t).x] within 8e-12
check [for t in linspace(0, 1, 6): s(t).y] ~= [for t in linspace(0, 1, 6): power_form_s(t).y] within 1e-11
check derivative(r, 0) ~= (9, 0, 0) within 9e-12
check derivative(r, 1) ~= (3, -3, 0) within 3e-12
check derivative(r, 0, order = 2) ~= (-18, -12, 0) within 1.8e-11
check derivative(r, 1, order = 2) ~= (6, 6, 0) within 6e-12
check r(1/2) ~= (11/4, 23/8, 0) within 2.87e-12
check derivative(p, 0) ~= (3, -3, 0) within 3e-12
check derivative(p, 1) ~= (3, 6, 0) within 6e-12
check derivative(p, 0, order = 2) ~= (6, 6, 0) within 6e-12
check derivative(p, 1, order = 2) ~= (-6, 12, 0) within 1.2e-11
check p(1/2) ~= (6, 3/8, 0) within 6e-12
check derivative(s, 0) ~= (3, 6, 0) within 6e-12
check derivative(s, 1) ~= (-27, -12, 0) within 2.7e-11
check derivative(s, 0, order = 2) ~= (-6, 12, 0) within 1.2e-11
check derivative(s, 1, order = 2) ~= (-54, -48, 0) within 5.4e-11
check s(1/2) ~= (31/4, 21/4, 0) within 7.75e-12
check continuity(r, p).c == 2
check continuity(r, p).g >= 2
check continuity(p, s).c == 2
check continuity(p, s).g >= 2
check continuity(s, r).c == 0
check continuity(s, r).g == 0
