// Linkeová: Bicubic Bezier = Coons bilinear (Example 3.11, Theorem 3.1, (3.40)-(3.42))
geo 1
curve c0 = bezier((0, 0, 4), (1, 0, 1), (2, 0, 1), (3, 0, 4))
curve c1 = bezier((0, 3, 1), (1, 3, 1), (2, 3, 1), (3, 3, 1))
curve d0 = bezier((0, 0, 4), (0, 1, 4), (0, 2, 1), (0, 3, 1))
curve d1 = bezier((3, 0, 4), (3, 1, 1), (3, 2, 1), (3, 3, 1))
surface s = coons(u = [c0, c1], v = [d0, d1])
fn form_x(u, v) = 3*u
check [for u in linspace(0, 1, 4), v in linspace(0, 1, 3): s(u, v).x] ~= [for u in linspace(0, 1, 4), v in linspace(0, 1, 3): form_x(u, v)] within 3e-12
fn form_y(u, v) = 3*v
check [for u in linspace(0, 1, 3), v in linspace(0, 1, 4): s(u, v).y] ~= [for u in linspace(0, 1, 3), v in linspace(0, 1, 4): form_y(u, v)] within 3e-12
fn form_z(u, v) = 4 - 9*v^2 + 6*v^3 - 9*u + 18*u*v^2 - 9*u*v^3 + 9*u^2 - 9*u^2*v
check [for u in linspace(0, 1, 5), v in linspace(0, 1, 6): s(u, v).z] ~= [for u in linspace(0, 1, 5), v in linspace(0, 1, 6): form_z(u, v)] within 1.8e-11
check s(0, 0) ~= (0, 0, 4) within 4e-12
check s(0, 1) ~= (0, 3, 1) within 3e-12
check s(1, 0) ~= (3, 0, 4) within 4e-12
check s(1, 1) ~= (3, 3, 1) within 3e-12
check derivative(s, 0, 0) ~= (3, 0, -9) within 9e-12
check derivative(s, 0, 1) ~= (3, 0, 0) within 3e-12
check derivative(s, 1, 0) ~= (3, 0, 9) within 9e-12
check derivative(s, 1, 1) ~= (3, 0, 0) within 3e-12
check derivative(s, 0, 0, du = 0, dv = 1) ~= (0, 3, 0) within 3e-12
check derivative(s, 0, 1, du = 0, dv = 1) ~= (0, 3, 0) within 3e-12
check derivative(s, 1, 0, du = 0, dv = 1) ~= (0, 3, -9) within 9e-12
check derivative(s, 1, 1, du = 0, dv = 1) ~= (0, 3, 0) within 3e-12
check twist(s, 0, 0) ~= (0, 0, 0) within 1e-12
check twist(s, 0, 1) ~= (0, 0, 9) within 9e-12
check twist(s, 1, 0) ~= (0, 0, -18) within 1.8e-11
check twist(s, 1, 1) ~= (0, 0, -9) within 9e-12
check [for t in linspace(0, 1, 5): s(t, 0).z] ~= [for t in linspace(0, 1, 5): 4 - 9*t + 9*t^2] within 9e-12
check [for t in linspace(0, 1, 3): s(t, 1).z] ~= [for t in linspace(0, 1, 3): 1] within 1e-12
check [for t in linspace(0, 1, 6): s(0, t).z] ~= [for t in linspace(0, 1, 6): 4 - 9*t^2 + 6*t^3] within 9e-12
check [for t in linspace(0, 1, 6): s(1, t).z] ~= [for t in linspace(0, 1, 6): 4 - 9*t + 9*t^2 - 3*t^3] within 9e-12
check s(0.5, 0.5) ~= (3/2, 3/2, 13/16) within 1.5e-12
check derivative(s, 0.5, 0.5) ~= (3, 0, -9/8) within 3e-12
check derivative(s, 0.5, 0.5, du = 0, dv = 1) ~= (0, 3, -9/8) within 3e-12
check twist(s, 0.5, 0.5) ~= (0, 0, 9/4) within 2.25e-12
check cross(derivative(s, 0.5, 0.5), derivative(s, 0.5, 0.5, du = 0, dv = 1)) ~= (27/8, 27/8, 9) within 9e-12
check s.points ~= [
  [(0, 0, 4), (0, 1, 4), (0, 2, 1), (0, 3, 1)],
  [(1, 0, 1), (1, 1, 1), (1, 2, 0), (1, 3, 1)],
  [(2, 0, 1), (2, 1, 0), (2, 2, 0), (2, 3, 1)],
  [(3, 0, 4), (3, 1, 1), (3, 2, 1), (3, 3, 1)],
] within 4e-12
