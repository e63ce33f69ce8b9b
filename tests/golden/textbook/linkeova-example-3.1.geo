// Linkeová: Ruled surface, boundaries in u (Example 3.1, (3.7)-(3.10))
geo 1
curve rail0 = polynomial([(0, 0, 2), (2, 0, 0), (0, 0, -1)])
curve rail1 = polynomial([(0, 2, 2), (2, 0, -4), (0, 0, 2)])
surface s = ruled(rail0, rail1)
fn form_x(u, v) = 2*u
check [for u in linspace(0, 1, 4), v in linspace(0, 1, 3): s(u, v).x] ~= [for u in linspace(0, 1, 4), v in linspace(0, 1, 3): form_x(u, v)] within 2e-12
fn form_y(u, v) = 2*v
check [for u in linspace(0, 1, 3), v in linspace(0, 1, 4): s(u, v).y] ~= [for u in linspace(0, 1, 3), v in linspace(0, 1, 4): form_y(u, v)] within 2e-12
fn form_z(u, v) = 2 - 4*u*v - u^2 + 3*u^2*v
check [for u in linspace(0, 1, 5), v in linspace(0, 1, 4): s(u, v).z] ~= [for u in linspace(0, 1, 5), v in linspace(0, 1, 4): form_z(u, v)] within 4e-12
check s(0, 0) ~= (0, 0, 2) within 2e-12
check s(0, 1) ~= (0, 2, 2) within 2e-12
check s(1, 0) ~= (2, 0, 1) within 2e-12
check s(1, 1) ~= (2, 2, 0) within 2e-12
check derivative(s, 0, 0) ~= (2, 0, 0) within 2e-12
check derivative(s, 0, 1) ~= (2, 0, -4) within 4e-12
check derivative(s, 1, 0) ~= (2, 0, -2) within 2e-12
check derivative(s, 1, 1) ~= (2, 0, 0) within 2e-12
check derivative(s, 0, 0, du = 0, dv = 1) ~= (0, 2, 0) within 2e-12
check derivative(s, 0, 1, du = 0, dv = 1) ~= (0, 2, 0) within 2e-12
check derivative(s, 1, 0, du = 0, dv = 1) ~= (0, 2, -1) within 2e-12
check derivative(s, 1, 1, du = 0, dv = 1) ~= (0, 2, -1) within 2e-12
check twist(s, 0, 0) ~= (0, 0, -4) within 4e-12
check twist(s, 0, 1) ~= (0, 0, -4) within 4e-12
check twist(s, 1, 0) ~= (0, 0, 2) within 2e-12
check twist(s, 1, 1) ~= (0, 0, 2) within 2e-12
check [for t in linspace(0, 1, 5): s(t, 0).z] ~= [for t in linspace(0, 1, 5): 2 - t^2] within 2e-12
check [for t in linspace(0, 1, 5): s(t, 1).z] ~= [for t in linspace(0, 1, 5): 2 - 4*t + 2*t^2] within 4e-12
check [for t in linspace(0, 1, 3): s(0, t).z] ~= [for t in linspace(0, 1, 3): 2] within 2e-12
check [for t in linspace(0, 1, 4): s(1, t).z] ~= [for t in linspace(0, 1, 4): 1 - t] within 1e-12
check s(0.5, 0.5) ~= (1, 1, 9/8) within 1.12e-12
check derivative(s, 0.5, 0.5) ~= (2, 0, -3/2) within 2e-12
check derivative(s, 0.5, 0.5, du = 0, dv = 1) ~= (0, 2, -5/4) within 2e-12
check twist(s, 0.5, 0.5) ~= (0, 0, -1) within 1e-12
check cross(derivative(s, 0.5, 0.5), derivative(s, 0.5, 0.5, du = 0, dv = 1)) ~= (3, 5/2, 4) within 4e-12
