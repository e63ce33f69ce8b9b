// Linkeová: Ruled surface between two spatial Bezier cubics in v (Example 3.3 b), Fig 3.3)
geo 1
curve rail0 = bezier((-1, 4, 1), (-2, 2, 2), (-1, 1, -1), (-1, 0, 2))
curve rail1 = bezier((3, 0, 3), (5, 1, 0), (4, 3, -1), (2, 1, -1))
surface s = swap_uv(ruled(rail0, rail1))
fn form_x(u, v) = -1 - 3*v + 6*v^2 - 3*v^3 + 4*u + 9*u*v - 15*u*v^2 + 5*u*v^3
check [for u in linspace(0, 1, 4), v in linspace(0, 1, 6): s(u, v).x] ~= [for u in linspace(0, 1, 4), v in linspace(0, 1, 6): form_x(u, v)] within 1.5e-11
fn form_y(u, v) = 4 - 6*v + 3*v^2 - v^3 - 4*u + 9*u*v - 4*u*v^3
check [for u in linspace(0, 1, 4), v in linspace(0, 1, 6): s(u, v).y] ~= [for u in linspace(0, 1, 4), v in linspace(0, 1, 6): form_y(u, v)] within 9e-12
fn form_z(u, v) = 1 + 3*v - 12*v^2 + 10*v^3 + 2*u - 12*u*v + 18*u*v^2 - 11*u*v^3
check [for u in linspace(0, 1, 4), v in linspace(0, 1, 6): s(u, v).z] ~= [for u in linspace(0, 1, 4), v in linspace(0, 1, 6): form_z(u, v)] within 1.8e-11
check s(0, 0) ~= (-1, 4, 1) within 4e-12
check s(0, 1) ~= (-1, 0, 2) within 2e-12
check s(1, 0) ~= (3, 0, 3) within 3e-12
check s(1, 1) ~= (2, 1, -1) within 2e-12
check derivative(s, 0, 0) ~= (4, -4, 2) within 4e-12
check derivative(s, 0, 1) ~= (3, 1, -3) within 3e-12
check derivative(s, 1, 0) ~= (4, -4, 2) within 4e-12
check derivative(s, 1, 1) ~= (3, 1, -3) within 3e-12
check derivative(s, 0, 0, du = 0, dv = 1) ~= (-3, -6, 3) within 6e-12
check derivative(s, 0, 1, du = 0, dv = 1) ~= (0, -3, 9) within 9e-12
check derivative(s, 1, 0, du = 0, dv = 1) ~= (6, 3, -9) within 9e-12
check derivative(s, 1, 1, du = 0, dv = 1) ~= (-6, -6, 0) within 6e-12
check twist(s, 0, 0) ~= (9, 9, -12) within 1.2e-11
check twist(s, 0, 1) ~= (-6, -3, -9) within 9e-12
check twist(s, 1, 0) ~= (9, 9, -12) within 1.2e-11
check twist(s, 1, 1) ~= (-6, -3, -9) within 9e-12
check de_casteljau(rail0, 1/2) ~= [
  [(-1, 4, 1), (-2, 2, 2), (-1, 1, -1), (-1, 0, 2)],
  [(-3/2, 3, 3/2), (-3/2, 3/2, 1/2), (-1, 1/2, 1/2)],
  [(-3/2, 9/4, 1), (-5/4, 1, 1/2)],
  [(-11/8, 13/8, 3/4)],
] within 4e-12
check de_casteljau(rail1, 1/2) ~= [
  [(3, 0, 3), (5, 1, 0), (4, 3, -1), (2, 1, -1)],
  [(4, 1/2, 3/2), (9/2, 2, -1/2), (3, 2, -1)],
  [(17/4, 5/4, 1/2), (15/4, 2, -3/4)],
  [(4, 13/8, -1/8)],
] within 5e-12
check s(0, 0.2) ~= (-173/125, 364/125, 6/5) within 2.91e-12
check s(0.2, 0) ~= (-1/5, 16/5, 7/5) within 3.2e-12
check s(0, 0.4) ~= (-179/125, 252/125, 23/25) within 2.02e-12
check s(0.4, 0) ~= (3/5, 12/5, 9/5) within 2.4e-12
check s(0, 0.6) ~= (-161/125, 158/125, 16/25) within 1.29e-12
check s(0.6, 0) ~= (7/5, 8/5, 11/5) within 2.2e-12
check s(0, 0.8) ~= (-137/125, 76/125, 21/25) within 1.1e-12
check s(0.8, 0) ~= (11/5, 4/5, 13/5) within 2.6e-12
check s(_, 0.2).points ~= [(-173/125, 364/125, 6/5), (482/125, 17/25, 179/125)] within 3.86e-12
check s(0.2, _).points ~= [(-1/5, 16/5, 7/5), (-3/5, 9/5, 8/5), (0, 7/5, -1), (-2/5, 1/5, 7/5)] within 3.2e-12
check s(_, 0.4).points ~= [(-179/125, 252/125, 23/25), (511/125, 34/25, 37/125)] within 4.09e-12
check s(0.4, _).points ~= [(3/5, 12/5, 9/5), (4/5, 8/5, 6/5), (1, 9/5, -1), (1/5, 2/5, 4/5)] within 2.4e-12
