// Linkeová: Points of a Bezier surface by both de Casteljau algorithms (Example 3.12, Fig 3.16)
geo 1
let net = [[(0, 0, 2), (0, 1, 0), (0, 2, 1)], [(1, 0, 0), (1, 1, 0), (1, 2, 0)], [(2, 0, 1), (2, 1, 0), (2, 2, 0)]]
surface s = bezier(net)
fn form_x(u, v) = 2*u
check [for u in linspace(0, 1, 4), v in linspace(0, 1, 3): s(u, v).x] ~= [for u in linspace(0, 1, 4), v in linspace(0, 1, 3): form_x(u, v)] within 2e-12
fn form_y(u, v) = 2*v
check [for u in linspace(0, 1, 3), v in linspace(0, 1, 4): s(u, v).y] ~= [for u in linspace(0, 1, 3), v in linspace(0, 1, 4): form_y(u, v)] within 2e-12
fn form_z(u, v) = 2 - 4*v + 3*v^2 - 4*u + 8*u*v - 6*u*v^2 + 3*u^2 - 6*u^2*v + 4*u^2*v^2
check [for u in linspace(0, 1, 5), v in linspace(0, 1, 5): s(u, v).z] ~= [for u in linspace(0, 1, 5), v in linspace(0, 1, 5): form_z(u, v)] within 8e-12
check s(0, 0) ~= (0, 0, 2) within 2e-12
check s(0, 1) ~= (0, 2, 1) within 2e-12
check s(1, 0) ~= (2, 0, 1) within 2e-12
check s(1, 1) ~= (2, 2, 0) within 2e-12
check derivative(s, 0, 0) ~= (2, 0, -4) within 4e-12
check derivative(s, 0, 1) ~= (2, 0, -2) within 2e-12
check derivative(s, 1, 0) ~= (2, 0, 2) within 2e-12
check derivative(s, 1, 1) ~= (2, 0, 0) within 2e-12
check derivative(s, 0, 0, du = 0, dv = 1) ~= (0, 2, -4) within 4e-12
check derivative(s, 0, 1, du = 0, dv = 1) ~= (0, 2, 2) within 2e-12
check derivative(s, 1, 0, du = 0, dv = 1) ~= (0, 2, -2) within 2e-12
check derivative(s, 1, 1, du = 0, dv = 1) ~= (0, 2, 0) within 2e-12
check twist(s, 0, 0) ~= (0, 0, 8) within 8e-12
check twist(s, 0, 1) ~= (0, 0, -4) within 4e-12
check twist(s, 1, 0) ~= (0, 0, -4) within 4e-12
check twist(s, 1, 1) ~= (0, 0, 0) within 1e-12
check [for t in linspace(0, 1, 5): s(t, 0).z] ~= [for t in linspace(0, 1, 5): 2 - 4*t + 3*t^2] within 4e-12
check [for t in linspace(0, 1, 5): s(t, 1).z] ~= [for t in linspace(0, 1, 5): 1 - 2*t + t^2] within 2e-12
check [for t in linspace(0, 1, 5): s(0, t).z] ~= [for t in linspace(0, 1, 5): 2 - 4*t + 3*t^2] within 4e-12
check [for t in linspace(0, 1, 5): s(1, t).z] ~= [for t in linspace(0, 1, 5): 1 - 2*t + t^2] within 2e-12
check s(0.5, 0.5) ~= (1, 1, 1/4) within 1e-12
check derivative(s, 0.5, 0.5) ~= (2, 0, -1/2) within 2e-12
check derivative(s, 0.5, 0.5, du = 0, dv = 1) ~= (0, 2, -1/2) within 2e-12
check twist(s, 0.5, 0.5) ~= (0, 0, 0) within 1e-12
check cross(derivative(s, 0.5, 0.5), derivative(s, 0.5, 0.5, du = 0, dv = 1)) ~= (1, 1, 4) within 4e-12
check s(0, 0.5) ~= (0, 1, 3/4) within 1e-12
check s(0.5, 0) ~= (1, 0, 3/4) within 1e-12
check s(0.5, 1) ~= (1, 2, 1/4) within 2e-12
check s(1, 0.5) ~= (2, 1, 1/4) within 2e-12
check s(1/2, 1/2) ~= (1, 1, 1/4) within 1e-12
check s(1/2, _).points ~= [(1, 0, 3/4), (1, 1, 0), (1, 2, 1/4)] within 2e-12
check tangent_plane(s, 0, 0).origin ~= (0, 0, 2) within 8e-12
check norm(cross(tangent_plane(s, 0, 0).z, (8, 8, 4))) ~= 0 within 1e-12
check tangent_plane(s, 0, 1).origin ~= (0, 2, 1) within 4e-12
check norm(cross(tangent_plane(s, 0, 1).z, (4, -4, 4))) ~= 0 within 1e-12
check tangent_plane(s, 1, 0).origin ~= (2, 0, 1) within 4e-12
check norm(cross(tangent_plane(s, 1, 0).z, (-4, 4, 4))) ~= 0 within 1e-12
check tangent_plane(s, 1, 1).origin ~= (2, 2, 0) within 4e-12
check norm(cross(tangent_plane(s, 1, 1).z, (0, 0, 4))) ~= 0 within 1e-12
