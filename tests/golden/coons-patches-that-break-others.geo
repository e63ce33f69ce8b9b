// Boundaries on which other programs miss an edge, throw, or are silent.
geo 1
let south = line((0, 0), (4, 0))
let north = line((0, 3), (4, 3))
let west = line((0, 0), (0, 3))
let stations = linspace(0, 1, 9)

// A corner that is open by a billionth is closed, and the surface goes through both curves.
curve loose = line((4, 0, 1e-9), (4, 3))
surface closed_corner = coons(u = [south, north], v = [west, loose])
check [for t in stations: closed_corner(t, 0)] ~= [for t in stations: south(t)] within 1e-9
check [for t in stations: closed_corner(1, t)] ~= [for t in stations: loose(t)] within 1e-9

// Edges of other degrees, knots, domains and directions.
curve many = interpolate([(4, 0), (5, 1, 1), (4.5, 2, 0.5), (4.2, 2.5), (4, 3)])
curve arched = arc_through((0, 0), (2, -1), (4, 0))
surface mixed = edge_surface([arched, many, reversed(north), bezier((0, 3), (-1, 2), (0, 1), (0.5, 0.5), (0, 0))])
check every([for t in linspace(0, 1, 17): closest(border(mixed), many(t)).distance < 1e-12])
check every([for t in linspace(0, 1, 17): closest(border(mixed), arched(t)).distance < 1e-12])

// A side that is one point.
surface triangle = coons(u = [south, line((2, 3), (2, 3))], v = [line((0, 0), (2, 3)), line((4, 0), (2, 3))])
check describe(triangle).collapsed == ["v1"]
check triangle(0.3, 1) ~= (2, 3)
check area(triangle) ~= 6 within 1e-12

// A boundary so hollow that the patch folds: the surface is made, and tells it.
surface hollow = coons(
    u = [bezier((0, 0), (2, 5), (4, 0)), north],
    v = [west, line((4, 0), (4, 3))],
)
check describe(bilinear((0, 0), (0, 3), (4, 0), (4, 3))).folds == []
check describe(hollow).folds == [] "up to 2.5 it stays below the other side"
surface folded = coons(
    u = [bezier((0, 0), (2, 8), (4, 0)), north],
    v = [west, line((4, 0), (4, 3))],
)
check len(describe(folded).folds) > 0
// It turns where its lower side, 16 t (1 - t), is above 3.
let turn = (1 - (1/4)^0.5)/2
check every([for p in describe(folded).folds: turn - 1e-6 < p.x and p.x < 1 - turn + 1e-6])
