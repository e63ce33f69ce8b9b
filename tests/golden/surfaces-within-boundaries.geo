// Surfaces within their edges, with the printed tables of the books.
geo 1

// Piegl & Tiller, (10.36): bilinearly blended, boundaries of degrees 3 and 2.
curve c0 = bezier((0, 0, 0), (1, 0, 2), (2, 0, 1), (4, 0, 0))
curve c1 = bezier((0, 3, 1), (2, 4, 0), (4, 3, 0))
curve d0 = bezier((0, 0, 0), (0, 1, 1), (0, 2, 3), (0, 3, 1))
curve d1 = bezier((4, 0, 0), (5, 1, 1), (4, 3, 0))
surface patch = coons(u = [c0, c1], v = [d0, d1])
check [patch.degree_u, patch.degree_v] == [3, 3]
check patch.points ~= [
    [(0, 0, 0), (0, 1, 1), (0, 2, 3), (0, 3, 1)],
    [(1, 0, 2), (4/3, 10/9, 19/9), (13/9, 7/3, 8/3), (4/3, 11/3, 1/3)],
    [(2, 0, 1), (8/3, 1, 4/3), (26/9, 20/9, 14/9), (8/3, 11/3, 0)],
    [(4, 0, 0), (14/3, 2/3, 2/3), (14/3, 5/3, 2/3), (4, 3, 0)],
] within 1e-14

// Linkeová, Example 3.16: clamped boundaries make a clamped surface.
let fifth = [0, 0, 0, 0, 1/2, 1, 1, 1, 1]
let sixth = [0, 0, 0, 0, 1/3, 2/3, 1, 1, 1, 1]
surface clamped_one = coons(
    u = [
        bspline([(0, 0, 3), (1, 0, 4), (2, 0, 3), (3, 0, 0), (4, 0, 2)], knots = fifth),
        bspline([(0, 5, 4), (1, 5, 0), (2, 5, 0), (3, 5, 0), (4, 5, 0)], knots = fifth),
    ],
    v = [
        bspline([(0, 0, 3), (0, 1, 3), (0, 2, 3), (0, 3, 1), (0, 4, 1), (0, 5, 4)], knots = sixth),
        bspline([(4, 0, 2), (4, 1, 0), (4, 2, 0), (4, 3, 2), (4, 4, 2), (4, 5, 0)], knots = sixth),
    ],
)
check [clamped_one.knots_u, clamped_one.knots_v] ~= [fifth, sixth]
check [for p in clamped_one.points[1]: p.z] ~= [4, 19/6, 13/6, -2/3, -5/3, 0] within 1e-14
check [for p in clamped_one.points[2]: p.z] ~= [3, 31/18, 7/6, 1/3, -2/9, 0] within 1e-14
check [for p in clamped_one.points[3]: p.z] ~= [0, -3/2, -7/6, 2/3, 1, 0] within 1e-14
check clamped_one.patches == [2, 3]

// Cubic blending: Vukašinović & Duhovnik, (1.46).
curve e0 = bezier((0, 0, 0), (1, 0, 1), (2, 0, 0))
curve e1 = bezier((0, 2, 0), (1, 2, -1), (2, 2, 1))
curve f0 = bezier((0, 0, 0), (0, 1, 2), (0, 2, 0))
curve f1 = bezier((2, 0, 0), (3, 1, 1), (2, 2, 1))
check coons(u = [e0, e1], v = [f0, f1])(1/4, 2/3) ~= (11/18, 4/3, 23/36) within 1e-15
check coons(u = [e0, e1], v = [f0, f1], blend = "cubic")(1/4, 2/3)
    ~= (41/72, 4/3, 23/36) within 1e-15

// Rational boundaries of other degrees, domains and weights: met, and halfway the mean of both.
curve low  = arc((0, 0, 0), 2, 180deg, 360deg)
curve high = conic((-2, 0, 5), (0, -3, 5), (2, 0, 5), 2)
curve left = line((-2, 0, 0), (-2, 0, 5))
curve right = bspline([(2, 0, 0), (3, 1, 2), (3, 0, 3), (2, 0, 5)], degree = 2)
surface mixed = coons(u = [low, high], v = [left, right])
let stations = linspace(0, 1, 9)
check [for t in stations: mixed(t, 0)] ~= [for t in stations: low(t)] within 1e-14
check [for t in stations: mixed(t, 1)] ~= [for t in stations: high(t)] within 1e-14
check [for t in stations: mixed(0, t)] ~= [for t in stations: left(t)] within 1e-14
check [for t in stations: mixed(1, t)] ~= [for t in stations: right(t)] within 1e-14
let middles = (low(1/2) + high(1/2) + left(1/2) + right(1/2)) / 2
let corners_mean = (0, 0, 2.5)
check mixed(1/2, 1/2) ~= middles - corners_mean within 1e-14

// A parametric boundary is converted within the document's tolerance, its ends exactly.
curve wave = parametric(t => (t, 0, sin(t * 1rad)), 0..2)
surface from_wave = coons(
    u = [wave, line((0, 1, 0), (2, 1, 0))],
    v = [line((0, 0, 0), (0, 1, 0)), line((2, 0, sin(2rad)), (2, 1, 0))],
)
check from_wave.domain_u == 0..2
check [for t in stations: from_wave(2*t, 0)] ~= [for t in stations: wave(2*t)]

// Edges in any order and direction: a ring is a ring.
curve south = bezier((0, 0, 0), (1, 0, 1), (2, 0, 0))
curve east  = line((2, 0, 0), (2, 2, 0))
curve north = bezier((0, 2, 0), (1, 2, -1), (2, 2, 0))
curve west  = line((0, 0, 0), (0, 2, 0))
surface ring = edge_surface([south, east, north, west])
check edge_surface([south, reversed(north), west, reversed(east)]).points ~= ring.points
check ring.points ~= coons(u = [south, north], v = [west, east]).points
check report(edge_surface([south, north, reversed(west), east])).order == [0, 3, 1, 2]
check report(edge_surface([south, north, reversed(west), east])).reversed == [1]

// Two edges are ruled, whatever their directions; three have a corner opposite to the first.
check edge_surface([south, reversed(north)])(0, 1) ~= (0, 2, 0)
surface sail = edge_surface([south, line((2, 0, 0), (1, 3, 0)), line((0, 0, 0), (1, 3, 0))])
check [sail(0.3, 0), sail(0.3, 1), sail(1, 0.5), sail(0, 0.5)]
    ~= [south(0.3), (1, 3, 0), (1.5, 1.5, 0), (0.5, 1.5, 0)] within 1e-15

// Four arcs of one circle: the corners are tangent, the disc is exact.
let quarters = [for k in 0..3: arc((0, 0), 2, k * 90deg, (k + 1) * 90deg)]
surface coin = edge_surface(quarters)
check [for t in stations: norm(coin(t, 0))] ~= [for t in stations: 2] within 1e-15
check [for t in stations: norm(coin(1, t))] ~= [for t in stations: 2] within 1e-15
check coin(0.5, 0.5) ~= (0, 0) within 1e-15

// A tube: closed curves, with one line as both sides.
let seam = line((2, 0, 0), (2, 0, 3))
surface tube = coons(u = [circle((0, 0), 2), circle((0, 0, 3), 2)], v = [seam, seam])
check hypot(tube(0.3, 0.6).x, tube(0.3, 0.6).y) ~= 2 within 1e-14
check tube.closed_u

// Corners in order around.
check corner_surface((0, 0), (2, 0), (2, 2, 1), (0, 2)).points
    ~= bilinear((0, 0), (0, 2), (2, 0), (2, 2, 1)).points
check corner_surface([(0, 0), (2, 0), (1, 3)])(0.4, 1) ~= (1, 3)
