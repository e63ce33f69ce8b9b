// Linkeová: Coons bilinear surface, Bezier cubic boundaries (Example 3.6, Fig 3.7)
geo 1
curve c0 = bezier((0, 0, 2), (1, 0, 0), (2, 0, 0), (3, 0, 1))
curve c1 = bezier((0, 3, 1), (1, 3, 0), (2, 3, 1), (3, 3, 1))
curve d0 = bezier((0, 0, 2), (0, 1, 2), (0, 2, 0), (0, 3, 1))
curve d1 = bezier((3, 0, 1), (3, 1, 0), (3, 2, 1), (3, 3, 1))
surface s = coons(u = [c0, c1], v = [d0, d1])
fn form_x(u, v) = 3*u
check [for u in linspace(0, 1, 4), v in linspace(0, 1, 3): s(u, v).x] ~= [for u in linspace(0, 1, 4), v in linspace(0, 1, 3): form_x(u, v)] within 3e-12
fn form_y(u, v) = 3*v
check [for u in linspace(0, 1, 3), v in linspace(0, 1, 4): s(u, v).y] ~= [for u in linspace(0, 1, 3), v in linspace(0, 1, 4): form_y(u, v)] within 3e-12
fn form_z(u, v) = 2 - 6*v^2 + 5*v^3 - 6*u - u*v + 12*u*v^2 - 8*u*v^3 + 6*u^2 - u^3 - 2*u^3*v
check [for u in linspace(0, 1, 6), v in linspace(0, 1, 6): s(u, v).z] ~= [for u in linspace(0, 1, 6), v in linspace(0, 1, 6): form_z(u, v)] within 1.2e-11
check s(0, 0) ~= (0, 0, 2) within 2e-12
check s(0, 1) ~= (0, 3, 1) within 3e-12
check s(1, 0) ~= (3, 0, 1) within 3e-12
check s(1, 1) ~= (3, 3, 1) within 3e-12
check derivative(s, 0, 0) ~= (3, 0, -6) within 6e-12
check derivative(s, 0, 1) ~= (3, 0, -3) within 3e-12
check derivative(s, 1, 0) ~= (3, 0, 3) within 3e-12
check derivative(s, 1, 1) ~= (3, 0, 0) within 3e-12
check derivative(s, 0, 0, du = 0, dv = 1) ~= (0, 3, 0) within 3e-12
check derivative(s, 0, 1, du = 0, dv = 1) ~= (0, 3, 3) within 3e-12
check derivative(s, 1, 0, du = 0, dv = 1) ~= (0, 3, -3) within 3e-12
check derivative(s, 1, 1, du = 0, dv = 1) ~= (0, 3, 0) within 3e-12
check twist(s, 0, 0) ~= (0, 0, -1) within 1e-12
check twist(s, 0, 1) ~= (0, 0, -1) within 1e-12
check twist(s, 1, 0) ~= (0, 0, -7) within 7e-12
check twist(s, 1, 1) ~= (0, 0, -7) within 7e-12
check [for t in linspace(0, 1, 6): s(t, 0).z] ~= [for t in linspace(0, 1, 6): 2 - 6*t + 6*t^2 - t^3] within 6e-12
check [for t in linspace(0, 1, 6): s(t, 1).z] ~= [for t in linspace(0, 1, 6): 1 - 3*t + 6*t^2 - 3*t^3] within 6e-12
check [for t in linspace(0, 1, 6): s(0, t).z] ~= [for t in linspace(0, 1, 6): 2 - 6*t^2 + 5*t^3] within 6e-12
check [for t in linspace(0, 1, 6): s(1, t).z] ~= [for t in linspace(0, 1, 6): 1 - 3*t + 6*t^2 - 3*t^3] within 6e-12
check s(0.5, 0.5) ~= (3/2, 3/2, 1/8) within 1.5e-12
check derivative(s, 0.5, 0.5) ~= (3, 0, 0) within 3e-12
check derivative(s, 0.5, 0.5, du = 0, dv = 1) ~= (0, 3, 0) within 3e-12
check twist(s, 0.5, 0.5) ~= (0, 0, 7/2) within 3.5e-12
check cross(derivative(s, 0.5, 0.5), derivative(s, 0.5, 0.5, du = 0, dv = 1)) ~= (0, 0, 9) within 9e-12
check s(0, 0.2) ~= (0, 3/5, 9/5) within 1.8e-12
check s(0.2, 0) ~= (3/5, 0, 129/125) within 1.03e-12
check s(0, 0.4) ~= (0, 6/5, 34/25) within 1.36e-12
check s(0.4, 0) ~= (6/5, 0, 62/125) within 1.2e-12
check s(0, 0.6) ~= (0, 9/5, 23/25) within 1.8e-12
check s(0.6, 0) ~= (9/5, 0, 43/125) within 1.8e-12
check s(0, 0.8) ~= (0, 12/5, 18/25) within 2.4e-12
check s(0.8, 0) ~= (12/5, 0, 66/125) within 2.4e-12
check s.points ~= [
  [(0, 0, 2), (0, 1, 2), (0, 2, 0), (0, 3, 1)],
  [(1, 0, 0), (1, 1, -1/9), (1, 2, -8/9), (1, 3, 0)],
  [(2, 0, 0), (2, 1, -2/9), (2, 2, 2/9), (2, 3, 1)],
  [(3, 0, 1), (3, 1, 0), (3, 2, 1), (3, 3, 1)],
] within 3e-12
