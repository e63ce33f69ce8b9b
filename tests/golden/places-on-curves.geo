// What stands out, what is nearest, where curves meet, and places by arc length.
curve ring = circle((0, 0), 2)
curve oval = scale(ring, (2, 1, 1))
curve wave = bezier((0, 0), (1, 2), (2, -2), (3, 0))
curve loop = bezier((0, 0), (4, 3), (-3, 3), (1, 0))
curve cusp = bezier((0, 0), (1, 1), (0, 1), (1, 0))
curve path = polyline((0, 0), (3, 4), (3, 5))

print inflections(wave), vertices(oval), extrema(wave, (0, 1)), corners(path), cusps(cusp)
check inflections(ring) == [] and vertices(ring) == [] "a circle has nothing that stands out"
check vertices(oval) ~= [0, 0.25, 0.5, 0.75] within 1e-12
check extrema(oval, (1, 0)) ~= [0, 0.5] within 1e-12 "the seam counts"
check curvature(oval, vertices(oval)[0]) ~= 4 / 2^2 within 1e-12 "a/b² at the long end"

let foot = closest(oval, (0, 1))
check foot.point ~= (0, 2) and foot.count == 1
check closest(oval, (0, 0)).count == 2 "both ends of the short axis"
check closest(path, (9, 9)).point == (3, 5) "ends count"

let meetings = intersect(ring, line((-3, 1), (3, 1)))
check [for m in meetings: m.point] ~= [(sqrt(3), 1), (-sqrt(3), 1)] within 1e-9
check len(intersect(ring, line((-3, 2), (3, 2)))) == 1 "a tangent touches once"
check intersect(ring, line((-3, 2.001), (3, 2.001))) == []
check len(intersect(ring, oval)) == 2
let own = self_intersections(loop)
check len(own) == 1 and loop(own[0].t) ~= loop(own[0].s)
check self_intersections(ring) == []
check section(oval, YZ) ~= [(0, 2), (0, -2)]

check parameter_at_length(ring, pi) ~= 0.25 within 1e-12
check divide(path, 6)[1] ~= (0.6, 0.8)
check divide(path, 6)[5] ~= (3, 4) "arc lengths"
