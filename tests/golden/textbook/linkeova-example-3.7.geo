// Linkeová: Biquadratic Bezier surface (Example 3.7, (3.29)-(3.32))
geo 1
let net = [[(0, 0, 2), (0, 1, 1), (0, 2, 3)], [(1, 0, 3), (1, 1, 0), (1, 2, 0)], [(2, 0, 1), (2, 1, 0), (2, 2, 0)]]
surface s = bezier(net)
fn form_x(u, v) = 2*u
check [for u in linspace(0, 1, 4), v in linspace(0, 1, 3): s(u, v).x] ~= [for u in linspace(0, 1, 4), v in linspace(0, 1, 3): form_x(u, v)] within 2e-12
fn form_y(u, v) = 2*v
check [for u in linspace(0, 1, 3), v in linspace(0, 1, 4): s(u, v).y] ~= [for u in linspace(0, 1, 3), v in linspace(0, 1, 4): form_y(u, v)] within 2e-12
fn form_z(u, v) = 2 - 2*v + 3*v^2 + 2*u - 8*u*v - 3*u^2 + 8*u^2*v - 2*u^2*v^2
check [for u in linspace(0, 1, 5), v in linspace(0, 1, 5): s(u, v).z] ~= [for u in linspace(0, 1, 5), v in linspace(0, 1, 5): form_z(u, v)] within 8e-12
check s(0, 0) ~= (0, 0, 2) within 2e-12
check s(0, 1) ~= (0, 2, 3) within 3e-12
check s(1, 0) ~= (2, 0, 1) within 2e-12
check s(1, 1) ~= (2, 2, 0) within 2e-12
check derivative(s, 0, 0) ~= (2, 0, 2) within 2e-12
check derivative(s, 0, 1) ~= (2, 0, -6) within 6e-12
check derivative(s, 1, 0) ~= (2, 0, -4) within 4e-12
check derivative(s, 1, 1) ~= (2, 0, 0) within 2e-12
check derivative(s, 0, 0, du = 0, dv = 1) ~= (0, 2, -2) within 2e-12
check derivative(s, 0, 1, du = 0, dv = 1) ~= (0, 2, 4) within 4e-12
check derivative(s, 1, 0, du = 0, dv = 1) ~= (0, 2, -2) within 2e-12
check derivative(s, 1, 1, du = 0, dv = 1) ~= (0, 2, 0) within 2e-12
check twist(s, 0, 0) ~= (0, 0, -8) within 8e-12
check twist(s, 0, 1) ~= (0, 0, -8) within 8e-12
check twist(s, 1, 0) ~= (0, 0, 8) within 8e-12
check twist(s, 1, 1) ~= (0, 0, 0) within 1e-12
check [for t in linspace(0, 1, 5): s(t, 0).z] ~= [for t in linspace(0, 1, 5): 2 + 2*t - 3*t^2] within 3e-12
check [for t in linspace(0, 1, 5): s(t, 1).z] ~= [for t in linspace(0, 1, 5): 3 - 6*t + 3*t^2] within 6e-12
check [for t in linspace(0, 1, 5): s(0, t).z] ~= [for t in linspace(0, 1, 5): 2 - 2*t + 3*t^2] within 3e-12
check [for t in linspace(0, 1, 5): s(1, t).z] ~= [for t in linspace(0, 1, 5): 1 - 2*t + t^2] within 2e-12
check s(0.5, 0.5) ~= (1, 1, 7/8) within 1e-12
check derivative(s, 0.5, 0.5) ~= (2, 0, -3/2) within 2e-12
check derivative(s, 0.5, 0.5, du = 0, dv = 1) ~= (0, 2, -3/2) within 2e-12
check twist(s, 0.5, 0.5) ~= (0, 0, -2) within 2e-12
check cross(derivative(s, 0.5, 0.5), derivative(s, 0.5, 0.5, du = 0, dv = 1)) ~= (3, 3, 4) within 4e-12
