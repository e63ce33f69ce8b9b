// Linkeová, Example 3.13: three patches that meet C2 and C1.
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
]
check s.points ~= [
  [(2, 0, 2), (2, 1, 0), (2, 2, 0), (2, 3, 0)],
  [(3, 0, 2), (3, 1, 0), (3, 2, 0), (3, 3, 0)],
  [(4, 0, 0), (4, 1, 0), (4, 2, 0), (4, 3, 0)],
]
// The two that lie along v are one surface with one knot between them.
print join([[p, r]]).knots_v

// Before the start the patch ends at the side, in the same directions.
surface q = continue_bezier(p, "u0", 2, [[(-3, 0, 0), (-3, 1, 0), (-3, 2, 0), (-3, 3, 0)]])
check edge(q, "u1").points ~= edge(p, "u0").points
check derivative(q, 1, 0.5, du = 2) ~= derivative(p, 0, 0.5, du = 2)
check q(0, 0.5) ~= (-3, 1.5, 0)

// A quarter of a pipe goes on straight: the weights of its side with it.
surface pipe = ruled(arc((0, 0), 1, 0deg, 90deg), arc((0, 0, 2), 1, 0deg, 90deg))
surface longer = continue_bezier(pipe, "v1", 1, [for row in pipe.points: [row[1] + (0, 0, 5)]])
check every(linspace(0, 1, 9), u => norm(longer(u, 0.7) - (0, 0, longer(u, 0.7).z)) ~= 1 within 1e-14)
check continue_bezier(p, "v1", 3, [[(0, 9)], [(1, 9)], [(2, 9)]]).degree_v == 4
