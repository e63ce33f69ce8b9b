// Linkeová: Hyperbolic paraboloid (Exercise 3.3)
geo 1
surface s = bilinear((0, 0, 2), (0, 3, 0), (3, 0, 0), (3, 3, 0))
fn form_x(u, v) = 3*u
check [for u in linspace(0, 1, 4), v in linspace(0, 1, 3): s(u, v).x] ~= [for u in linspace(0, 1, 4), v in linspace(0, 1, 3): form_x(u, v)] within 3e-12
fn form_y(u, v) = 3*v
check [for u in linspace(0, 1, 3), v in linspace(0, 1, 4): s(u, v).y] ~= [for u in linspace(0, 1, 3), v in linspace(0, 1, 4): form_y(u, v)] within 3e-12
fn form_z(u, v) = 2 - 2*v - 2*u + 2*u*v
check [for u in linspace(0, 1, 4), v in linspace(0, 1, 4): s(u, v).z] ~= [for u in linspace(0, 1, 4), v in linspace(0, 1, 4): form_z(u, v)] within 2e-12
check s(0, 0) ~= (0, 0, 2) within 2e-12
check s(0, 1) ~= (0, 3, 0) within 3e-12
check s(1, 0) ~= (3, 0, 0) within 3e-12
check s(1, 1) ~= (3, 3, 0) within 3e-12
check derivative(s, 0, 0) ~= (3, 0, -2) within 3e-12
check derivative(s, 0, 1) ~= (3, 0, 0) within 3e-12
check derivative(s, 1, 0) ~= (3, 0, -2) within 3e-12
check derivative(s, 1, 1) ~= (3, 0, 0) within 3e-12
check derivative(s, 0, 0, du = 0, dv = 1) ~= (0, 3, -2) within 3e-12
check derivative(s, 0, 1, du = 0, dv = 1) ~= (0, 3, -2) within 3e-12
check derivative(s, 1, 0, du = 0, dv = 1) ~= (0, 3, 0) within 3e-12
check derivative(s, 1, 1, du = 0, dv = 1) ~= (0, 3, 0) within 3e-12
check twist(s, 0, 0) ~= (0, 0, 2) within 2e-12
check twist(s, 0, 1) ~= (0, 0, 2) within 2e-12
check twist(s, 1, 0) ~= (0, 0, 2) within 2e-12
check twist(s, 1, 1) ~= (0, 0, 2) within 2e-12
check [for t in linspace(0, 1, 4): s(t, 0).z] ~= [for t in linspace(0, 1, 4): 2 - 2*t] within 2e-12
check [for t in linspace(0, 1, 3): s(t, 1).z] ~= [for t in linspace(0, 1, 3): 0] within 1e-12
check [for t in linspace(0, 1, 4): s(0, t).z] ~= [for t in linspace(0, 1, 4): 2 - 2*t] within 2e-12
check [for t in linspace(0, 1, 3): s(1, t).z] ~= [for t in linspace(0, 1, 3): 0] within 1e-12
check s(0.5, 0.5) ~= (3/2, 3/2, 1/2) within 1.5e-12
check derivative(s, 0.5, 0.5) ~= (3, 0, -1) within 3e-12
check derivative(s, 0.5, 0.5, du = 0, dv = 1) ~= (0, 3, -1) within 3e-12
check twist(s, 0.5, 0.5) ~= (0, 0, 2) within 2e-12
check cross(derivative(s, 0.5, 0.5), derivative(s, 0.5, 0.5, du = 0, dv = 1)) ~= (3, 3, 9) within 9e-12
