// Linkeová: Bezier surface: boundary mid points, corner tangent planes (Example 3.10, Fig 3.11)
geo 1
let net = [
  [(0, 0, 2), (0, 1, 2), (0, 2, 0), (0, 3, 2)],
  [(1, 0, 2), (1, 1, 0), (1, 2, 0), (1, 3, 0)],
  [(2, 0, 2), (2, 1, 0), (2, 2, 0), (2, 3, 0)],
  [(3, 0, 1), (3, 1, 0), (3, 2, 0), (3, 3, 0)],
]
surface s = bezier(net)
fn form_x(u, v) = 3*u
check [for u in linspace(0, 1, 4), v in linspace(0, 1, 3): s(u, v).x] ~= [for u in linspace(0, 1, 4), v in linspace(0, 1, 3): form_x(u, v)] within 3e-12
fn form_y(u, v) = 3*v
check [for u in linspace(0, 1, 3), v in linspace(0, 1, 4): s(u, v).y] ~= [for u in linspace(0, 1, 3), v in linspace(0, 1, 4): form_y(u, v)] within 3e-12
fn form_z(u, v) = 2 - 6*v^2 + 6*v^3 - 18*u*v + 36*u*v^2 - 24*u*v^3 + 18*u^2*v - 36*u^2*v^2 + 24*u^2*v^3 - u^3 - 3*u^3*v + 9*u^3*v^2 - 7*u^3*v^3
check [for u in linspace(0, 1, 6), v in linspace(0, 1, 6): s(u, v).z] ~= [for u in linspace(0, 1, 6), v in linspace(0, 1, 6): form_z(u, v)] within 3.6e-11
check s(0, 0) ~= (0, 0, 2) within 2e-12
check s(0, 1) ~= (0, 3, 2) within 3e-12
check s(1, 0) ~= (3, 0, 1) within 3e-12
check s(1, 1) ~= (3, 3, 0) within 3e-12
check derivative(s, 0, 0) ~= (3, 0, 0) within 3e-12
check derivative(s, 0, 1) ~= (3, 0, -6) within 6e-12
check derivative(s, 1, 0) ~= (3, 0, -3) within 3e-12
check derivative(s, 1, 1) ~= (3, 0, 0) within 3e-12
check derivative(s, 0, 0, du = 0, dv = 1) ~= (0, 3, 0) within 3e-12
check derivative(s, 0, 1, du = 0, dv = 1) ~= (0, 3, 6) within 6e-12
check derivative(s, 1, 0, du = 0, dv = 1) ~= (0, 3, -3) within 3e-12
check derivative(s, 1, 1, du = 0, dv = 1) ~= (0, 3, 0) within 3e-12
check twist(s, 0, 0) ~= (0, 0, -18) within 1.8e-11
check twist(s, 0, 1) ~= (0, 0, -18) within 1.8e-11
check twist(s, 1, 0) ~= (0, 0, 9) within 9e-12
check twist(s, 1, 1) ~= (0, 0, 0) within 1e-12
check [for t in linspace(0, 1, 6): s(t, 0).z] ~= [for t in linspace(0, 1, 6): 2 - t^3] within 2e-12
check [for t in linspace(0, 1, 6): s(t, 1).z] ~= [for t in linspace(0, 1, 6): 2 - 6*t + 6*t^2 - 2*t^3] within 6e-12
check [for t in linspace(0, 1, 6): s(0, t).z] ~= [for t in linspace(0, 1, 6): 2 - 6*t^2 + 6*t^3] within 6e-12
check [for t in linspace(0, 1, 6): s(1, t).z] ~= [for t in linspace(0, 1, 6): 1 - 3*t + 3*t^2 - t^3] within 3e-12
check s(0.5, 0.5) ~= (3/2, 3/2, 23/64) within 1.5e-12
check derivative(s, 0.5, 0.5) ~= (3, 0, -27/32) within 3e-12
check derivative(s, 0.5, 0.5, du = 0, dv = 1) ~= (0, 3, -45/32) within 3e-12
check twist(s, 0.5, 0.5) ~= (0, 0, 9/16) within 1e-12
check cross(derivative(s, 0.5, 0.5), derivative(s, 0.5, 0.5, du = 0, dv = 1)) ~= (81/32, 135/32, 9) within 9e-12
check s(0.5, 0) ~= (3/2, 0, 15/8) within 1.87e-12
check s(0.5, 1) ~= (3/2, 3, 1/4) within 3e-12
check s(0, 0.5) ~= (0, 3/2, 5/4) within 1.5e-12
check s(1, 0.5) ~= (3, 3/2, 1/8) within 3e-12
check tangent_plane(s, 0, 0).origin ~= (0, 0, 2) within 9e-12
check norm(cross(tangent_plane(s, 0, 0).z, (0, 0, 9))) ~= 0 within 1e-12
check tangent_plane(s, 0, 1).origin ~= (0, 3, 2) within 1.8e-11
check norm(cross(tangent_plane(s, 0, 1).z, (18, -18, 9))) ~= 0 within 1e-12
check tangent_plane(s, 1, 0).origin ~= (3, 0, 1) within 9e-12
check norm(cross(tangent_plane(s, 1, 0).z, (9, 9, 9))) ~= 0 within 1e-12
check tangent_plane(s, 1, 1).origin ~= (3, 3, 0) within 9e-12
check norm(cross(tangent_plane(s, 1, 1).z, (0, 0, 9))) ~= 0 within 1e-12
