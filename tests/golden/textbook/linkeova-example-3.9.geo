// Linkeová: Bezier surface: boundary mid points, corner tangent planes (Example 3.9, Fig 3.10)
geo 1
let net = [
  [(0, 0, 2), (0, 1, 0), (0, 2, 0), (0, 3, 1)],
  [(1, 0, 2), (1, 1, 0), (1, 2, 0), (1, 3, 0)],
  [(2, 0, 0), (2, 1, 0), (2, 2, 0), (2, 3, 0)],
]
surface s = bezier(net)
fn form_x(u, v) = 2*u
check [for u in linspace(0, 1, 4), v in linspace(0, 1, 3): s(u, v).x] ~= [for u in linspace(0, 1, 4), v in linspace(0, 1, 3): form_x(u, v)] within 2e-12
fn form_y(u, v) = 3*v
check [for u in linspace(0, 1, 3), v in linspace(0, 1, 4): s(u, v).y] ~= [for u in linspace(0, 1, 3), v in linspace(0, 1, 4): form_y(u, v)] within 3e-12
fn form_z(u, v) = 2 - 6*v + 6*v^2 - v^3 - 2*u*v^3 - 2*u^2 + 6*u^2*v - 6*u^2*v^2 + 3*u^2*v^3
check [for u in linspace(0, 1, 5), v in linspace(0, 1, 6): s(u, v).z] ~= [for u in linspace(0, 1, 5), v in linspace(0, 1, 6): form_z(u, v)] within 6e-12
check s(0, 0) ~= (0, 0, 2) within 2e-12
check s(0, 1) ~= (0, 3, 1) within 3e-12
check s(1, 0) ~= (2, 0, 0) within 2e-12
check s(1, 1) ~= (2, 3, 0) within 3e-12
check derivative(s, 0, 0) ~= (2, 0, 0) within 2e-12
check derivative(s, 0, 1) ~= (2, 0, -2) within 2e-12
check derivative(s, 1, 0) ~= (2, 0, -4) within 4e-12
check derivative(s, 1, 1) ~= (2, 0, 0) within 2e-12
check derivative(s, 0, 0, du = 0, dv = 1) ~= (0, 3, -6) within 6e-12
check derivative(s, 0, 1, du = 0, dv = 1) ~= (0, 3, 3) within 3e-12
check derivative(s, 1, 0, du = 0, dv = 1) ~= (0, 3, 0) within 3e-12
check derivative(s, 1, 1, du = 0, dv = 1) ~= (0, 3, 0) within 3e-12
check twist(s, 0, 0) ~= (0, 0, 0) within 1e-12
check twist(s, 0, 1) ~= (0, 0, -6) within 6e-12
check twist(s, 1, 0) ~= (0, 0, 12) within 1.2e-11
check twist(s, 1, 1) ~= (0, 0, 0) within 1e-12
check [for t in linspace(0, 1, 5): s(t, 0).z] ~= [for t in linspace(0, 1, 5): 2 - 2*t^2] within 2e-12
check [for t in linspace(0, 1, 5): s(t, 1).z] ~= [for t in linspace(0, 1, 5): 1 - 2*t + t^2] within 2e-12
check [for t in linspace(0, 1, 6): s(0, t).z] ~= [for t in linspace(0, 1, 6): 2 - 6*t + 6*t^2 - t^3] within 6e-12
check [for t in linspace(0, 1, 3): s(1, t).z] ~= [for t in linspace(0, 1, 3): 0] within 1e-12
check s(0.5, 0.5) ~= (1, 3/2, 7/32) within 1.5e-12
check derivative(s, 0.5, 0.5) ~= (2, 0, -3/8) within 2e-12
check derivative(s, 0.5, 0.5, du = 0, dv = 1) ~= (0, 3, -15/16) within 3e-12
check twist(s, 0.5, 0.5) ~= (0, 0, 3/4) within 1e-12
check cross(derivative(s, 0.5, 0.5), derivative(s, 0.5, 0.5, du = 0, dv = 1)) ~= (9/8, 15/8, 6) within 6e-12
check s(0.5, 0) ~= (1, 0, 3/2) within 1.5e-12
check s(0.5, 1) ~= (1, 3, 1/4) within 3e-12
check s(0, 0.5) ~= (0, 3/2, 3/8) within 1.5e-12
check s(1, 0.5) ~= (2, 3/2, 0) within 2e-12
check tangent_plane(s, 0, 0).origin ~= (0, 0, 2) within 1.2e-11
check norm(cross(tangent_plane(s, 0, 0).z, (0, 12, 6))) ~= 0 within 1e-12
check tangent_plane(s, 0, 1).origin ~= (0, 3, 1) within 6e-12
check norm(cross(tangent_plane(s, 0, 1).z, (6, -6, 6))) ~= 0 within 1e-12
check tangent_plane(s, 1, 0).origin ~= (2, 0, 0) within 1.2e-11
check norm(cross(tangent_plane(s, 1, 0).z, (12, 0, 6))) ~= 0 within 1e-12
check tangent_plane(s, 1, 1).origin ~= (2, 3, 0) within 6e-12
check norm(cross(tangent_plane(s, 1, 1).z, (0, 0, 6))) ~= 0 within 1e-12
