check [for p in [XY, YZ, ZX]: p.z] == [(0, 0, 1), (1, 0, 0), (0, 1, 0)]
check [for p in [XY, YZ, ZX]: p.x] == [(1, 0, 0), (0, 1, 0), (0, 0, 1)]
let tilted = plane((1, 2, 3), (1, 1, 0))
check dot(tilted.x, tilted.z) ~= 0 within 1e-15
check cross(tilted.x, tilted.y) ~= tilted.z within 1e-15

curve c = helix((5, 0), 2, 1, 1)
check mirror(mirror(c, tilted), tilted).points ~= c.points within 1e-12
check mirror([(1, 2, 3), [(4, 5, 6)]], YZ) == [(-1, 2, 3), [(-4, 5, 6)]]
check place(c, XY).points == c.points
check place((0, 0), tilted) ~= (1, 2, 3) within 1e-15
check place((0, 0, 2), tilted) - (1, 2, 3) ~= 2*tilted.z within 1e-15
check transform(c, [[1, 0, 0, 1cm], [0, 1, 0, 0], [0, 0, 1, 0]]).start ~= c.start + (10, 0) within 1e-12
check project(c, XY).end ~= (7, 0, 0) within 1e-12
check every([for t in linspace(0, 1, 9): norm(project(c, XY)(t) - (5, 0)) ~= 2])

// Across a spine.
curve spine = hermite([(0, 0, 0), (10, 0, 10)], [(0, 0, 20), (20, 0, 0)])
curve ring = station(circle((0, 0), 1), spine, 0.5)
check every([for t in linspace(0, 1, 9): distance(ring(t), spine(0.5)) ~= 1 within 1e-12])
check every([for t in linspace(0, 1, 9): dot(ring(t) - spine(0.5), tangent(spine, 0.5)) ~= 0 within 1e-12])
check station(circle((7, 7), 1), spine, 0.5, anchor = 0.25)(0.25) ~= spine(0.5) within 1e-12
check station(line((-1, 0, 1), (1, 0, 3)), spine, 1, anchor = 0.5).points ~= [(10, 0, 10 - sqrt(2)), (10, 0, 10 + sqrt(2))] within 1e-12
