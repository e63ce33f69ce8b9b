// Where a cut goes over the seam of a surface its edge goes on, wherever the seam lies.
let ball = solid(sphere((0, 0), 2))
let caps = [for n in [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, 0, 1), (0.3, -0.7, 0.2)]: cut(ball, plane(0.8 * n / norm(n), n))]
check every([for c in caps: len(edges(c)) == 1 and report(c).edges == 1 and report(c).vertices == 1 and len(c.vertices) == 1])
check every([for c in caps: length(edges(c)[0]) ~= 2 * pi * sqrt(4 - 0.64) within 1e-6])
check every([for c in caps: report(c).least_edge ~= 2 * pi * sqrt(4 - 0.64) within 1e-6])
check every([for c in caps: edges(c)[0].closed])
// Corners between the same faces stay: a box whose side is one surface.
region square = region(polyline((0, 0), (2, 0), (2, 1), (0, 1), closed = true))
print report(extrude(square, (0, 0, 3))).edges, report(extrude(square, (0, 0, 3))).vertices
