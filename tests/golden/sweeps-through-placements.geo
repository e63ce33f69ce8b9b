// Algorithm A10.2: a cubic skin through as many placements as are asked for, at even parameters.
let ring = circle((0, 0), 1, normal = (1, 0, 0))
let path = bezier((0, 0, 0), (4, 0, 4), (4, 6, -2), (0, 6, 2))
surface six = sweep(ring, path, keep_path = false, sections = 6)
print report(six).placements, report(six).control_points, six.degree_v
check every(report(six).placements, v => every(linspace(0, 1, 9), u => norm(six(u, v) - path(v)) ~= 1 within 1e-14))
check every(report(six).placements, v => every(linspace(0, 1, 9), u => abs(dot(six(u, v) - path(v), tangent(path, v))) < 1e-9))
print sweep(ring, path, keep_path = false, sections = 3).degree_v

// Around a closed path the skin is periodic, and has no weights of the path.
let round = circle((0, 0), 4)
surface closed = sweep(ring, round, keep_path = false, sections = 9)
check every(report(closed).placements, v => norm(closed(0, v) - circle((0, 0), 3)(v)) < 1e-14)
check norm(derivative(closed, 0.2, 0, du = 0, dv = 1) - derivative(closed, 0.2, 1, du = 0, dv = 1)) < 1e-12
check report(sweep(ring, round, keep_path = false)).deviation.max < 1e-6

// The limit of projections from place to place does not turn about the path: it is the same
// however many knots the path has.
surface projected = sweep(ring, path, frame = "projection")
check every(linspace(0, 1, 5), v => projected(0, v) ~= sweep(ring, path)(0, v) within 1e-9)
check every(linspace(0, 1, 5), v => projected(0, v) ~= sweep(ring, refine(path, [0.1, 0.2, 0.7]), frame = "projection")(0, v) within 2e-6)

// Columns about the control points of the path: within the tolerance too, and the path is met.
surface offsets = sweep(ring, path, method = "offsets", tolerance = 1e-3)
check report(offsets).deviation.max <= 1e-3
check every(linspace(0, 1, 9), v => every(linspace(0, 1, 9), u => norm(offsets(u, v) - path(v)) ~= 1 within 1e-3))
let spot = sweep(line((0, 0, 0), (0, 0, 1)), path, method = "offsets", tolerance = 1e-2)
check every(linspace(0, 1, 9), v => spot(0, v) ~= path(v) within 1e-13)
