// Linkeová: Two Bezier cubics forming a closed (heart) curve (Exercise 2.5)
geo 1
curve p = bezier((0, 0), (3, 2), (1, 3), (0, 2))
curve r = bezier((0, 2), (-1, 3), (-3, 2), (0, 0))
curve power_form_p = polynomial([(0, 0), (9, 6), (-15, -3), (6, -1)])
check [for t in linspace(0, 1, 6): p(t).x] ~= [for t in linspace(0, 1, 6): power_form_p(t).x] within 1.5e-11
check [for t in linspace(0, 1, 6): p(t).y] ~= [for t in linspace(0, 1, 6): power_form_p(t).y] within 6e-12
check p(0) ~= (0, 0, 0) within 1e-12
check derivative(p, 0) ~= (9, 6, 0) within 9e-12
check p(0.5) ~= (3/2, 17/8, 0) within 2.12e-12
check derivative(p, 0.5) ~= (-3/2, 9/4, 0) within 2.25e-12
check p(1) ~= (0, 2, 0) within 2e-12
check derivative(p, 1) ~= (-3, -3, 0) within 3e-12
check de_casteljau(p, 1/2) ~= [
  [(0, 0, 0), (3, 2, 0), (1, 3, 0), (0, 2, 0)],
  [(3/2, 1, 0), (2, 5/2, 0), (1/2, 5/2, 0)],
  [(7/4, 7/4, 0), (5/4, 5/2, 0)],
  [(3/2, 17/8, 0)],
] within 3e-12
curve power_form_r = polynomial([(0, 2), (-3, 3), (-3, -6), (6, 1)])
check [for t in linspace(0, 1, 6): r(t).x] ~= [for t in linspace(0, 1, 6): power_form_r(t).x] within 6e-12
check [for t in linspace(0, 1, 6): r(t).y] ~= [for t in linspace(0, 1, 6): power_form_r(t).y] within 6e-12
check r(0) ~= (0, 2, 0) within 2e-12
check derivative(r, 0) ~= (-3, 3, 0) within 3e-12
check r(0.5) ~= (-3/2, 17/8, 0) within 2.12e-12
check derivative(r, 0.5) ~= (-3/2, -9/4, 0) within 2.25e-12
check r(1) ~= (0, 0, 0) within 1e-12
check derivative(r, 1) ~= (9, -6, 0) within 9e-12
check de_casteljau(r, 1/2) ~= [
  [(0, 2, 0), (-1, 3, 0), (-3, 2, 0), (0, 0, 0)],
  [(-1/2, 5/2, 0), (-2, 5/2, 0), (-3/2, 1, 0)],
  [(-5/4, 5/2, 0), (-7/4, 7/4, 0)],
  [(-3/2, 17/8, 0)],
] within 3e-12
check continuity(p, r).c == 0
check continuity(p, r).g == 0
check continuity(r, p).c == 0
check continuity(r, p).g == 0
