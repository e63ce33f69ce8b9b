// Linkeová: Patching: C2 in v (R) and C1 in u (S) (Example 3.13, (3.51), Fig 3.17)
geo 1
let net = [
  [(0, 0, 1), (0, 1, 0), (0, 2, 2), (0, 3, 3)],
  [(1, 0, 2), (1, 1, 0), (1, 2, 0), (1, 3, 0)],
  [(2, 0, 2), (2, 1, 0), (2, 2, 0), (2, 3, 0)],
]
surface p = bezier(net)
surface r = continue_bezier(p, "v1", 2, [[(0, 6, 0)], [(1, 6, 0)], [(2, 6, 0)]])
surface s = continue_bezier(p, "u1", 1, [[(4, 0, 0), (4, 1, 0), (4, 2, 0), (4, 3, 0)]])
check r.points ~= [
  [(0, 3, 3), (0, 4, 4), (0, 5, 4), (0, 6, 0)],
  [(1, 3, 0), (1, 4, 0), (1, 5, 0), (1, 6, 0)],
  [(2, 3, 0), (2, 4, 0), (2, 5, 0), (2, 6, 0)],
] within 6e-12
check s.points ~= [
  [(2, 0, 2), (2, 1, 0), (2, 2, 0), (2, 3, 0)],
  [(3, 0, 2), (3, 1, 0), (3, 2, 0), (3, 3, 0)],
  [(4, 0, 0), (4, 1, 0), (4, 2, 0), (4, 3, 0)],
] within 4e-12
check p(0.5, 0) ~= (1, 0, 7/4) within 1.75e-12
check p(0.5, 1) ~= (1, 3, 3/4) within 3e-12
check p(0, 0.5) ~= (0, 3/2, 5/4) within 1.5e-12
check p(1, 0.5) ~= (2, 3/2, 1/4) within 2e-12
check r(0.5, 0) ~= (1, 3, 3/4) within 3e-12
check r(0.5, 1) ~= (1, 6, 0) within 6e-12
check r(0, 0.5) ~= (0, 9/2, 27/8) within 4.5e-12
check r(1, 0.5) ~= (2, 9/2, 0) within 4.5e-12
check s(0.5, 0) ~= (3, 0, 3/2) within 3e-12
check s(0.5, 1) ~= (3, 3, 0) within 3e-12
check s(0, 0.5) ~= (2, 3/2, 1/4) within 2e-12
check s(1, 0.5) ~= (4, 3/2, 0) within 4e-12
check continuity(p, r, "v1", "v0").c >= 2
check continuity(p, s, "u1", "u0").c == 1
