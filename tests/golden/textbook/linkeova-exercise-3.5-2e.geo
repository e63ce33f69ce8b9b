// Linkeová: Bezier boundaries: ruled (Exercise 3.5 2(e))
geo 1
curve rail0 = bezier((0, 0, 3), (0, 1, 2), (0, 2, 0), (0, 3, 2))
curve rail1 = bezier((3, 0, 1), (3, 1, 0), (3, 2, 1), (3, 3, 0))
surface s = swap_uv(ruled(rail0, rail1))
fn form_x(u, v) = 3*u
check [for u in linspace(0, 1, 4), v in linspace(0, 1, 3): s(u, v).x] ~= [for u in linspace(0, 1, 4), v in linspace(0, 1, 3): form_x(u, v)] within 3e-12
fn form_y(u, v) = 3*v
check [for u in linspace(0, 1, 3), v in linspace(0, 1, 4): s(u, v).y] ~= [for u in linspace(0, 1, 3), v in linspace(0, 1, 4): form_y(u, v)] within 3e-12
fn form_z(u, v) = 3 - 3*v - 3*v^2 + 5*v^3 - 2*u + 9*u*v^2 - 9*u*v^3
check [for u in linspace(0, 1, 4), v in linspace(0, 1, 6): s(u, v).z] ~= [for u in linspace(0, 1, 4), v in linspace(0, 1, 6): form_z(u, v)] within 9e-12
check s(0, 0) ~= (0, 0, 3) within 3e-12
check s(0, 1) ~= (0, 3, 2) within 3e-12
check s(1, 0) ~= (3, 0, 1) within 3e-12
check s(1, 1) ~= (3, 3, 0) within 3e-12
check derivative(s, 0, 0) ~= (3, 0, -2) within 3e-12
check derivative(s, 0, 1) ~= (3, 0, -2) within 3e-12
check derivative(s, 1, 0) ~= (3, 0, -2) within 3e-12
check derivative(s, 1, 1) ~= (3, 0, -2) within 3e-12
check derivative(s, 0, 0, du = 0, dv = 1) ~= (0, 3, -3) within 3e-12
check derivative(s, 0, 1, du = 0, dv = 1) ~= (0, 3, 6) within 6e-12
check derivative(s, 1, 0, du = 0, dv = 1) ~= (0, 3, -3) within 3e-12
check derivative(s, 1, 1, du = 0, dv = 1) ~= (0, 3, -3) within 3e-12
check twist(s, 0, 0) ~= (0, 0, 0) within 1e-12
check twist(s, 0, 1) ~= (0, 0, -9) within 9e-12
check twist(s, 1, 0) ~= (0, 0, 0) within 1e-12
check twist(s, 1, 1) ~= (0, 0, -9) within 9e-12
check [for t in linspace(0, 1, 4): s(t, 0).z] ~= [for t in linspace(0, 1, 4): 3 - 2*t] within 3e-12
check [for t in linspace(0, 1, 4): s(t, 1).z] ~= [for t in linspace(0, 1, 4): 2 - 2*t] within 2e-12
check [for t in linspace(0, 1, 6): s(0, t).z] ~= [for t in linspace(0, 1, 6): 3 - 3*t - 3*t^2 + 5*t^3] within 5e-12
check [for t in linspace(0, 1, 6): s(1, t).z] ~= [for t in linspace(0, 1, 6): 1 - 3*t + 6*t^2 - 4*t^3] within 6e-12
check s(0.5, 0.5) ~= (3/2, 3/2, 15/16) within 1.5e-12
check derivative(s, 0.5, 0.5) ~= (3, 0, -7/8) within 3e-12
check derivative(s, 0.5, 0.5, du = 0, dv = 1) ~= (0, 3, -9/8) within 3e-12
check twist(s, 0.5, 0.5) ~= (0, 0, 9/4) within 2.25e-12
check cross(derivative(s, 0.5, 0.5), derivative(s, 0.5, 0.5, du = 0, dv = 1)) ~= (21/8, 27/8, 9) within 9e-12
check s(0, 0.5) ~= (0, 3/2, 11/8) within 1.5e-12
check s(1, 0.5) ~= (3, 3/2, 1/2) within 3e-12
check s(0.5, 0) ~= (3/2, 0, 2) within 2e-12
check s(0.5, 1) ~= (3/2, 3, 1) within 3e-12
