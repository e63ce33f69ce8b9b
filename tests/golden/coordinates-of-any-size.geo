// Squares of such coordinates are no numbers, or zero; the answers are those for moderate ones.
geo 1
let looped = [(0, 0), (4, 3), (-3, 3), (1, 0)]
let own = self_intersections(bezier(looped))[0]
fn crossing(by) = self_intersections(bezier([for p in looped: by * p]))
check every([for by in [1e-3, 1e150, 1e300]: len(crossing(by)) == 1])
check every([for by in [1e-3, 1e150, 1e300]: abs(crossing(by)[0].t - own.t) < 1e-9])
check every([for by in [1e-3, 1e150, 1e300]: norm(crossing(by)[0].point / by - own.point) < 1e-9])

curve small = bezier([for p in looped: 1e-300 * p])
check tangent(small, 0.3) ~= tangent(bezier(looped), 0.3) within 1e-14
check curvature(small, 0.3) * 1e-300 ~= curvature(bezier(looped), 0.3) within 1e-12

// Less than the coordinates are rounded by, an offset is the curve.
check offset(bezier(looped), 1e-300).points == bezier(looped).points
check offset(bezier([for p in looped: 1e300 * p]), 0.1).points == [for p in looped: (1e300 * p)]

// However far a curve goes on.
check extend(line((0, 0), (3, 4)), 1e12).end ~= (6e11, 8e11) within 10
check extend(clamped((0, 0), (1, 1), (2, 2), (3, 3), (4, 4)), 1e9).end ~= (4 + 1e9/2^0.5, 4 + 1e9/2^0.5) within 1e-3

// A far point, and one curve of a hundred degrees met by a line.
check closest(line((0, 0), (1, 0)), (1e300, 1)).distance == 1e300
curve high = bezier([for i in 0..100: (i, (-1)^i)])
// Its height is (1 - 2 t)^100.
let meetings = intersect(high, line((-1, 0.5), (101, 0.5)))
let root = (1 - 0.5^0.01)/2
check [for m in meetings: m.t] ~= [root, 1 - root] within 1e-9
