// Linkeová: Coons = ruled_u + ruled_v - bilinear (Exercise 3.6 (data of Examples 3.1, 3.2 and 3.4; the text says 3.3))
geo 1
curve c0 = polynomial([(0, 0, 2), (2, 0, 0), (0, 0, -1)])
curve c1 = polynomial([(0, 2, 2), (2, 0, -4), (0, 0, 2)])
curve d0 = polynomial([(0, 0, 2), (0, 2, -4), (0, 0, 4)])
curve d1 = polynomial([(2, 0, 1), (0, 2, -2), (0, 0, 1)])
surface s = coons(u = [c0, c1], v = [d0, d1])
fn form_x(u, v) = 2*u
check [for u in linspace(0, 1, 4), v in linspace(0, 1, 3): s(u, v).x] ~= [for u in linspace(0, 1, 4), v in linspace(0, 1, 3): form_x(u, v)] within 2e-12
fn form_y(u, v) = 2*v
check [for u in linspace(0, 1, 3), v in linspace(0, 1, 4): s(u, v).y] ~= [for u in linspace(0, 1, 3), v in linspace(0, 1, 4): form_y(u, v)] within 2e-12
fn form_z(u, v) = 2 - 4*v + 4*v^2 - u*v - 3*u*v^2 - u^2 + 3*u^2*v
check [for u in linspace(0, 1, 5), v in linspace(0, 1, 5): s(u, v).z] ~= [for u in linspace(0, 1, 5), v in linspace(0, 1, 5): form_z(u, v)] within 4e-12
check s(1/3, 0.25) ~= (2/3, 1/2, 155/144) within 1.08e-12
check s(2/3, 0.875) ~= (4/3, 7/4, 49/288) within 1.75e-12
