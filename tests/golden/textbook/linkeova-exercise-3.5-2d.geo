// Linkeová: Bezier boundaries: ruled (Exercise 3.5 2(d))
geo 1
curve rail0 = bezier((0, 0, 3), (1, 0, 0), (2, 0, 0), (3, 0, 1))
curve rail1 = bezier((0, 3, 2), (1, 3, 0), (2, 3, 1), (3, 3, 0))
surface s = ruled(rail0, rail1)
fn form_x(u, v) = 3*u
check [for u in linspace(0, 1, 4), v in linspace(0, 1, 3): s(u, v).x] ~= [for u in linspace(0, 1, 4), v in linspace(0, 1, 3): form_x(u, v)] within 3e-12
fn form_y(u, v) = 3*v
check [for u in linspace(0, 1, 3), v in linspace(0, 1, 4): s(u, v).y] ~= [for u in linspace(0, 1, 3), v in linspace(0, 1, 4): form_y(u, v)] within 3e-12
fn form_z(u, v) = 3 - v - 9*u + 3*u*v + 9*u^2 - 2*u^3 - 3*u^3*v
check [for u in linspace(0, 1, 6), v in linspace(0, 1, 4): s(u, v).z] ~= [for u in linspace(0, 1, 6), v in linspace(0, 1, 4): form_z(u, v)] within 9e-12
check s(0, 0) ~= (0, 0, 3) within 3e-12
check s(0, 1) ~= (0, 3, 2) within 3e-12
check s(1, 0) ~= (3, 0, 1) within 3e-12
check s(1, 1) ~= (3, 3, 0) within 3e-12
check derivative(s, 0, 0) ~= (3, 0, -9) within 9e-12
check derivative(s, 0, 1) ~= (3, 0, -6) within 6e-12
check derivative(s, 1, 0) ~= (3, 0, 3) within 3e-12
check derivative(s, 1, 1) ~= (3, 0, -3) within 3e-12
check derivative(s, 0, 0, du = 0, dv = 1) ~= (0, 3, -1) within 3e-12
check derivative(s, 0, 1, du = 0, dv = 1) ~= (0, 3, -1) within 3e-12
check derivative(s, 1, 0, du = 0, dv = 1) ~= (0, 3, -1) within 3e-12
check derivative(s, 1, 1, du = 0, dv = 1) ~= (0, 3, -1) within 3e-12
check twist(s, 0, 0) ~= (0, 0, 3) within 3e-12
check twist(s, 0, 1) ~= (0, 0, 3) within 3e-12
check twist(s, 1, 0) ~= (0, 0, -6) within 6e-12
check twist(s, 1, 1) ~= (0, 0, -6) within 6e-12
check [for t in linspace(0, 1, 6): s(t, 0).z] ~= [for t in linspace(0, 1, 6): 3 - 9*t + 9*t^2 - 2*t^3] within 9e-12
check [for t in linspace(0, 1, 6): s(t, 1).z] ~= [for t in linspace(0, 1, 6): 2 - 6*t + 9*t^2 - 5*t^3] within 9e-12
check [for t in linspace(0, 1, 4): s(0, t).z] ~= [for t in linspace(0, 1, 4): 3 - t] within 3e-12
check [for t in linspace(0, 1, 4): s(1, t).z] ~= [for t in linspace(0, 1, 4): 1 - t] within 1e-12
check s(0.5, 0.5) ~= (3/2, 3/2, 9/16) within 1.5e-12
check derivative(s, 0.5, 0.5) ~= (3, 0, -9/8) within 3e-12
check derivative(s, 0.5, 0.5, du = 0, dv = 1) ~= (0, 3, 1/8) within 3e-12
check twist(s, 0.5, 0.5) ~= (0, 0, 3/4) within 1e-12
check cross(derivative(s, 0.5, 0.5), derivative(s, 0.5, 0.5, du = 0, dv = 1)) ~= (27/8, -3/8, 9) within 9e-12
check s(0, 0.5) ~= (0, 3/2, 5/2) within 2.5e-12
check s(1, 0.5) ~= (3, 3/2, 1/2) within 3e-12
check s(0.5, 0) ~= (3/2, 0, 1/2) within 1.5e-12
check s(0.5, 1) ~= (3/2, 3, 5/8) within 3e-12
