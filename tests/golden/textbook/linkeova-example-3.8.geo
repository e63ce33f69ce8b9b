// Linkeová: Bezier surface with a rectangular map (2x3) (Example 3.8, (3.33)-(3.36))
geo 1
let net = [
  [(0, 0, 5), (0, 1, 5), (0, 2, 2), (0, 3, 5)],
  [(1, 0, 2), (1, 1, 1), (1, 2, 0), (1, 3, 2)],
  [(2, 0, 5), (2, 1, 2), (2, 2, 2), (2, 3, 2)],
]
surface s = bezier(net)
fn form_x(u, v) = 2*u
check [for u in linspace(0, 1, 4), v in linspace(0, 1, 3): s(u, v).x] ~= [for u in linspace(0, 1, 4), v in linspace(0, 1, 3): form_x(u, v)] within 2e-12
fn form_y(u, v) = 3*v
check [for u in linspace(0, 1, 3), v in linspace(0, 1, 4): s(u, v).y] ~= [for u in linspace(0, 1, 3), v in linspace(0, 1, 4): form_y(u, v)] within 3e-12
fn form_z(u, v) = 5 - 9*v^2 + 9*v^3 - 6*u - 6*u*v + 18*u*v^2 - 12*u*v^3 + 6*u^2 - 3*u^2*v
check [for u in linspace(0, 1, 5), v in linspace(0, 1, 6): s(u, v).z] ~= [for u in linspace(0, 1, 5), v in linspace(0, 1, 6): form_z(u, v)] within 1.8e-11
check s(0, 0) ~= (0, 0, 5) within 5e-12
check s(0, 1) ~= (0, 3, 5) within 5e-12
check s(1, 0) ~= (2, 0, 5) within 5e-12
check s(1, 1) ~= (2, 3, 2) within 3e-12
check derivative(s, 0, 0) ~= (2, 0, -6) within 6e-12
check derivative(s, 0, 1) ~= (2, 0, -6) within 6e-12
check derivative(s, 1, 0) ~= (2, 0, 6) within 6e-12
check derivative(s, 1, 1) ~= (2, 0, 0) within 2e-12
check derivative(s, 0, 0, du = 0, dv = 1) ~= (0, 3, 0) within 3e-12
check derivative(s, 0, 1, du = 0, dv = 1) ~= (0, 3, 9) within 9e-12
check derivative(s, 1, 0, du = 0, dv = 1) ~= (0, 3, -9) within 9e-12
check derivative(s, 1, 1, du = 0, dv = 1) ~= (0, 3, 0) within 3e-12
check twist(s, 0, 0) ~= (0, 0, -6) within 6e-12
check twist(s, 0, 1) ~= (0, 0, -6) within 6e-12
check twist(s, 1, 0) ~= (0, 0, -12) within 1.2e-11
check twist(s, 1, 1) ~= (0, 0, -12) within 1.2e-11
check [for t in linspace(0, 1, 5): s(t, 0).z] ~= [for t in linspace(0, 1, 5): 5 - 6*t + 6*t^2] within 6e-12
check [for t in linspace(0, 1, 5): s(t, 1).z] ~= [for t in linspace(0, 1, 5): 5 - 6*t + 3*t^2] within 6e-12
check [for t in linspace(0, 1, 6): s(0, t).z] ~= [for t in linspace(0, 1, 6): 5 - 9*t^2 + 9*t^3] within 9e-12
check [for t in linspace(0, 1, 6): s(1, t).z] ~= [for t in linspace(0, 1, 6): 5 - 9*t + 9*t^2 - 3*t^3] within 9e-12
check s(0.5, 0.5) ~= (1, 3/2, 2) within 2e-12
check derivative(s, 0.5, 0.5) ~= (2, 0, -3/2) within 2e-12
check derivative(s, 0.5, 0.5, du = 0, dv = 1) ~= (0, 3, -3/2) within 3e-12
check twist(s, 0.5, 0.5) ~= (0, 0, 0) within 1e-12
check cross(derivative(s, 0.5, 0.5), derivative(s, 0.5, 0.5, du = 0, dv = 1)) ~= (9/2, 3, 6) within 6e-12
