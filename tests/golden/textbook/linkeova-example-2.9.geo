// Linkeová: Two Bezier cubics: C1, not C2, but G2 (Example 2.9, (2.44)-(2.46))
geo 1
curve p = bezier((1, 2), (0, 1), (0, 0), (1, 0))
curve r = bezier((1, 0), (2, 0), (2, 1), (2, 2))
curve power_form_p = polynomial([(1, 2), (-3, -3), (3, 0), (0, 1)])
check [for t in linspace(0, 1, 6): p(t).x] ~= [for t in linspace(0, 1, 6): power_form_p(t).x] within 3e-12
check [for t in linspace(0, 1, 6): p(t).y] ~= [for t in linspace(0, 1, 6): power_form_p(t).y] within 3e-12
curve power_form_r = polynomial([(1, 0), (3, 0), (-3, 3), (1, -1)])
check [for t in linspace(0, 1, 6): r(t).x] ~= [for t in linspace(0, 1, 6): power_form_r(t).x] within 3e-12
check [for t in linspace(0, 1, 6): r(t).y] ~= [for t in linspace(0, 1, 6): power_form_r(t).y] within 3e-12
check derivative(p, 1) ~= (3, 0, 0) within 3e-12
check derivative(r, 0) ~= (3, 0, 0) within 3e-12
check derivative(p, 1, order = 2) ~= (6, 6, 0) within 6e-12
check derivative(r, 0, order = 2) ~= (-6, 6, 0) within 6e-12
check curvature(p, 1) ~= 2/3 within 1e-12
check curvature(r, 0) ~= 2/3 within 1e-12
check radius_of_curvature(p, 1) ~= 3/2 within 1.5e-12
check center_of_curvature(p, 1) ~= (1, 3/2, 0) within 1.5e-12
check continuity(p, r).c == 1
check continuity(p, r).g >= 2
