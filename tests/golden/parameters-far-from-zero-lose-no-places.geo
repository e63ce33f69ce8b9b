/// Seconds of an epoch as parameters: one step of such a number moves the point by more than the tolerance.
let track = bezier((0, 0), (300, 100), (600, -100))
let logged = reparametrize(track, 1.7e9..1.7e9 + 10)

check section(track, plane((100, 0, 0), (1, 0, 0))) ~= [(100, 25, 0)]
check section(logged, plane((100, 0, 0), (1, 0, 0))) ~= [(100, 25, 0)]
check len(section(track, plane((0, 11, 0), (0, 1, 0)))) == 2
check len(section(logged, plane((0, 11, 0), (0, 1, 0)))) == 2

let level = line((-10, 11), (700, 11))
check len(intersect(track, level)) == 2
check len(intersect(logged, level)) == 2
check every(intersect(logged, level), f = p => p.point.y ~= 11)
check len(intersect(extrude(logged, (0, 0, 20)), plane_patch((-10, 11, -5), (700, 0, 0), (0, 0, 30)))) == 2
check len(section(extrude(logged, (0, 0, 20)), plane((0, 11, 0), (0, 1, 0)))) == 2

/// A circle far from the origin stands out along a direction in two places, one of them at its seam.
check every([0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9], f = x => len(extrema(circle((1e5 + x, 1e5, x), 1, normal = (0.3, x, 1)), (1, 0, 0))) == 2)

/// Knots a billionth apart are knots.
let narrow = nurbs([(0, 0), (1, 1), (2, -1), (3, 0.5)], degree = 1, knots = [0, 0, 1e-9, 2e-9, 1, 1])
check extrema(narrow, (0, 1)) == [1e-9, 2e-9]
check section(narrow, plane((0, 0.5, 0), (0, 1, 0))) ~= [(0.5, 0.5), (1.25, 0.5), (3, 0.5)]
