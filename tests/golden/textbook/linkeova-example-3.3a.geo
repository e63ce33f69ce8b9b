// Linkeová: Ruled surface between two spatial Bezier cubics in v (Example 3.3 a), Fig 3.3)
geo 1
curve rail0 = bezier((1, 0, 1), (2, 1, 1), (3, 0, 0), (4, 1, 0))
curve rail1 = bezier((0, 3, 2), (0, 4, 1), (2, 3, 0), (3, 4, -1))
surface s = swap_uv(ruled(rail0, rail1))
fn form_x(u, v) = 1 + 3*v - u - 3*u*v + 6*u*v^2 - 3*u*v^3
check [for u in linspace(0, 1, 4), v in linspace(0, 1, 6): s(u, v).x] ~= [for u in linspace(0, 1, 4), v in linspace(0, 1, 6): form_x(u, v)] within 6e-12
fn form_y(u, v) = 3*v - 6*v^2 + 4*v^3 + 3*u
check [for u in linspace(0, 1, 4), v in linspace(0, 1, 6): s(u, v).y] ~= [for u in linspace(0, 1, 4), v in linspace(0, 1, 6): form_y(u, v)] within 6e-12
fn form_z(u, v) = 1 - 3*v^2 + 2*v^3 + u - 3*u*v + 3*u*v^2 - 2*u*v^3
check [for u in linspace(0, 1, 4), v in linspace(0, 1, 6): s(u, v).z] ~= [for u in linspace(0, 1, 4), v in linspace(0, 1, 6): form_z(u, v)] within 3e-12
check s(0, 0) ~= (1, 0, 1) within 1e-12
check s(0, 1) ~= (4, 1, 0) within 4e-12
check s(1, 0) ~= (0, 3, 2) within 3e-12
check s(1, 1) ~= (3, 4, -1) within 4e-12
check derivative(s, 0, 0) ~= (-1, 3, 1) within 3e-12
check derivative(s, 0, 1) ~= (-1, 3, -1) within 3e-12
check derivative(s, 1, 0) ~= (-1, 3, 1) within 3e-12
check derivative(s, 1, 1) ~= (-1, 3, -1) within 3e-12
check derivative(s, 0, 0, du = 0, dv = 1) ~= (3, 3, 0) within 3e-12
check derivative(s, 0, 1, du = 0, dv = 1) ~= (3, 3, 0) within 3e-12
check derivative(s, 1, 0, du = 0, dv = 1) ~= (0, 3, -3) within 3e-12
check derivative(s, 1, 1, du = 0, dv = 1) ~= (3, 3, -3) within 3e-12
check twist(s, 0, 0) ~= (-3, 0, -3) within 3e-12
check twist(s, 0, 1) ~= (0, 0, -3) within 3e-12
check twist(s, 1, 0) ~= (-3, 0, -3) within 3e-12
check twist(s, 1, 1) ~= (0, 0, -3) within 3e-12
check de_casteljau(rail0, 1/2) ~= [
  [(1, 0, 1), (2, 1, 1), (3, 0, 0), (4, 1, 0)],
  [(3/2, 1/2, 1), (5/2, 1/2, 1/2), (7/2, 1/2, 0)],
  [(2, 1/2, 3/4), (3, 1/2, 1/4)],
  [(5/2, 1/2, 1/2)],
] within 4e-12
check de_casteljau(rail1, 1/2) ~= [
  [(0, 3, 2), (0, 4, 1), (2, 3, 0), (3, 4, -1)],
  [(0, 7/2, 3/2), (1, 7/2, 1/2), (5/2, 7/2, -1/2)],
  [(1/2, 7/2, 1), (7/4, 7/2, 0)],
  [(9/8, 7/2, 1/2)],
] within 4e-12
check s(0, 0.2) ~= (8/5, 49/125, 112/125) within 1.6e-12
check s(0.2, 0) ~= (4/5, 3/5, 6/5) within 1.2e-12
check s(0, 0.4) ~= (11/5, 62/125, 81/125) within 2.2e-12
check s(0.4, 0) ~= (3/5, 6/5, 7/5) within 1.4e-12
check s(0, 0.6) ~= (14/5, 63/125, 44/125) within 2.8e-12
check s(0.6, 0) ~= (2/5, 9/5, 8/5) within 1.8e-12
check s(0, 0.8) ~= (17/5, 76/125, 13/125) within 3.4e-12
check s(0.8, 0) ~= (1/5, 12/5, 9/5) within 2.4e-12
check s(_, 0.2).points ~= [(8/5, 49/125, 112/125), (27/125, 424/125, 7/5)] within 3.39e-12
check s(0.2, _).points ~= [(4/5, 3/5, 6/5), (8/5, 8/5, 1), (14/5, 3/5, 0), (19/5, 8/5, -1/5)] within 3.8e-12
check s(_, 0.4).points ~= [(11/5, 62/125, 81/125), (96/125, 437/125, 4/5)] within 3.5e-12
check s(0.4, _).points ~= [(3/5, 6/5, 7/5), (6/5, 11/5, 1), (13/5, 6/5, 0), (18/5, 11/5, -2/5)] within 3.6e-12
