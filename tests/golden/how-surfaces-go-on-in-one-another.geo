// Linkeova, Curves and Surfaces for Computer Graphics, Definitions 1.31 to 1.34.
// Parts of one paraboloid, with other parameters: as smooth as it is, whatever the parameters say.
fn bowl(x, y) = (x, y, x^2 + y^2/2)
surface left = parametric((u, v) => bowl(u, v), 0..1, 0..1)
surface right = parametric((u, v) => bowl(u, v), 1..2, 0..1)
surface faster = parametric((u, v) => bowl(1 + 2*u, v), 0..1, 0..1)
surface turned = parametric((u, v) => bowl(2 - u, 1 - v), 0..1, 0..1)
surface swapped = parametric((u, v) => bowl(1 + v, u), 0..1, 0..1)
check continuity(left, right, "u1", "u0").c == 3 and continuity(left, right, "u1", "u0").g == 3
check continuity(left, right, "u1", "u0").c_homogeneous == 3
check continuity(left, faster, "u1", "u0").c == 0 and continuity(left, faster, "u1", "u0").g == 3
check continuity(left, turned, "u1", "u1").c == 3 and continuity(left, turned, "u1", "u1").g == 3
check continuity(left, swapped, "u1", "v0").c == 3 and continuity(left, swapped, "u1", "v0").g == 3
check continuity(right, left, "u0", "u1").c == 3 "either way round"
check continuity(left, right, "u0", "u1").c == -1 "these edges are apart"
check continuity(left, right, "u0", "u1").g == -1
check continuity(left, right, "u0", "u1").gap ~= hypot(2, 4) within 1e-12

// The same edge with other parameters along it is the same edge.
surface eased = parametric((u, v) => bowl(1 + u, v^2), 0..1, 0.5..1)
surface whole = parametric((u, v) => bowl(u, v), 0..1, 0.25..1)
check continuity(whole, eased, "u1", "u0").g == 3 and continuity(whole, eased, "u1", "u0").c == 0

// A plane goes on in a cylinder of radius 2 with its tangent, not with its curvature.
surface floor = bilinear((-1, 0), (-1, 1), (0, 0), (0, 1))
surface roll = parametric((u, v) => (2*sin(u), v, 2 - 2*cos(u)), 0..1, 0..1)
let met = continuity(floor, roll, "u1", "u0")
check met.g == 1 and met.gap ~= 0 and met.angle < 1e-12rad
check met.curvature_gap ~= 0.5 within 1e-12
// x = sin u, z = 1 - cos u + (u - sin u) differs from the first third derivative on.
surface spiral = parametric((u, v) => (2*sin(u), v, 2 - 2*cos(u) + u^3/10), 0..1, 0..1)
check continuity(parametric((u, v) => (-2*sin(u), v, 2 - 2*cos(u)), 0..1, 0..1), spiral, "u0", "u0").g == 2

// Corners, and a surface that turns back.
surface wall = bilinear((0, 0), (0, 1), (0, 0, 1), (0, 1, 1))
surface back = bilinear((0, 0), (0, 1), (-1, 0), (-1, 1))
check continuity(floor, wall, "u1", "u0").g == 0 and continuity(floor, wall, "u1", "u0").angle ~= 90deg
check continuity(floor, back, "u1", "u0").g == 0 and continuity(floor, back, "u1", "u0").angle ~= 180deg
surface off = bilinear((0.001, 0), (0, 1), (1, 0), (1, 1))
check continuity(floor, off, "u1", "u0").gap ~= 0.001 within 1e-9
check continuity(floor, off, "u1", "u0").at ~= (0, 0, 0) within 0.001

// Bezier patches: the conditions on their nets, of which the middle of one row is off.
let net = [[(0, 0, 1), (0, 1, 0), (0, 2, 2)], [(1, 0, 2), (1, 1, 0), (1, 2, 0)], [(2, 0, 2), (2, 1, 0), (2, 2, 0)]]
fn beyond(bend) = [
  net[2],
  [for j in 0..2: 2*net[2][j] - net[1][j]],
  [for j in 0..2: 4*(net[2][j] - net[1][j]) + net[0][j] + (if j == 1 then (0, 0, bend) else (0, 0, 0))],
]
check continuity(bezier(net), bezier(beyond(0)), "u1", "u0").c == 3 "degree 2 has nothing beyond C2"
check continuity(bezier(net), bezier(beyond(1e-3)), "u1", "u0").c == 1
check continuity(bezier(net), bezier(beyond(1e-3)), "u1", "u0").g == 1

// Of one surface: inner knots, and seams.
surface ring = parametric((u, v) => ((3 + cos(v))*cos(u), (3 + cos(v))*sin(u), sin(v)), 0..tau, 0..tau)
check continuity(ring).c == 3 and continuity(ring).g == 3
check continuity(bspline([[(0, 0), (0, 1)], [(1, 0), (1, 1)], [(2, 0, 1), (2, 1, 1)]], degree = 1)).angle ~= 45deg
surface cubic = bspline([for i in 0..5: [for j in 0..4: (i, j, sin(1rad*i*j))]])
check continuity(cubic).c == 2 and continuity(cubic).g == 2
check continuity(bezier(net)).at == none "one piece has no joint"
print met
