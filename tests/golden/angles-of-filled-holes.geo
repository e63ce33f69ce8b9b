// Twists that contradict one another turn the surface against its cross field beside the corner.
let u = [line((0, 0), (1, 0)), line((0, 1), (1, 1))]
let v = [line((0, 0), (0, 1)), line((1, 0), (1, 1))]
let level_u = [line((0, 1), (0, 1)), line((0, 1), (0, 1))]
let level_v = [line((1, 0), (1, 0)), line((1, 0), (1, 0))]
print report(coons_bicubic(u = u, v = v, cross_u = level_u, cross_v = level_v, angle = 0deg)).angle
let bent = [bezier((0, 1), (0, 1, 1), (0, 1)), line((0, 1), (0, 1))]
surface filled = coons_bicubic(u = u, v = v, cross_u = bent, cross_v = level_v, angle = 30deg)
let reached = report(filled).angle
check 0deg < reached.max and reached.max < 30deg
// It is the angle between the plane of the field and that of the surface.
let given = if reached.boundary == "u[0]" then cross((1, 0), bent[0](reached.at)) else (0, 0, 1)
let n = if reached.boundary == "u[0]" then normal(filled, reached.at, 0) else normal(filled, 0, reached.at)
check abs(dot(n, given))/norm(given) ~= cos(reached.max) within 1e-9
// Each of the four curves has its angle, those whose fields are kept none.
let angles = report(filled).angles
print [for one in angles: one.boundary]
check max([for one in angles: one.max]) == reached.max
check angles[1].max ~= 0deg
