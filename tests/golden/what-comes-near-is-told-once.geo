// Places of a curve within the tolerance of a surface or a plane, each once, by closed forms.

// A piece that lies in the plane is told by its two ends, whichever way the curve leaves it.
fn xs(c) = [for p in section(c, XY): p.x]
check xs(polyline((-1, 0, 1), (0, 0, 0), (1, 0, 0), (2, 0, -1))) ~= [0, 1] within 1e-9
check xs(polyline((-1, 0, 1), (0, 0, 0), (3, 0, 0), (4, 2, -1))) ~= [0, 3] within 1e-9
check xs(polyline((-1, 0, 1), (0, 0, 0), (1, 0, 0), (2, 0, 1), (3, 0, 0), (4, 0, 0), (5, 0, -1))) ~= [0, 1, 3, 4] within 1e-9
check xs(polyline((-1, 0, 1), (0, 0, 5e-7), (1, 0, 5e-7), (2, 0, 1))) ~= [0, 1] within 1e-9
check xs(join([bezier((-1, 0, 1), (-0.5, 0, 1), (0, 0, 0)), line((0, 0, 0), (1, 0, 0)), line((1, 0, 0), (2, 0, -1))])) ~= [0, 1] within 1e-9

// An end that is short of a wall, a line beside a ball, and one beside a corner.
let gaps = [0, 1e-11, 1e-8, 1e-7, 5e-7, 9e-7, 2e-6]
fn counts(meet) = [for e in gaps: len(meet(e))]
let once = [1, 1, 1, 1, 1, 1, 0]
surface wall = plane_patch((1, -1, -1), (0, 2, 0), (0, 0, 2))
check counts(e => intersect(line((0, 0, 0), (1 - e, 0, 0)), wall)) == once
check counts(e => intersect(line((0, 0, 0), (1 - e, 0.3, 0.2)), wall)) == once
check counts(e => intersect(line((1 + e, -2, 0), (1 + e, 2, 0)), sphere((0, 0, 0), 1))) == once
check counts(e => intersect(line((0, 0, 1 + e), (0, 0, 3)), sphere((0, 0, 0), 1))) == once
check counts(e => intersect(line((1 + e, 1, -1), (1 + e, 1, 1)), plane_patch((0, 0, 0), (1, 0, 0), (0, 1, 0)))) == once
check counts(e => intersect(circle((0, 0, 0), 2), plane_patch((2 + e, -1, -1), (0, 2, 0), (0, 0, 2)))) == once
// At the nearest place, its end.
check intersect(line((0, 0, 0), (1 - 5e-7, 0, 0)), wall)[0].t == 1
// What is just through is one crossing, with nothing told beside it.
check [for a in [80deg, 10deg, 2deg, 1deg]: len(intersect(line((0, 0, 1), (cos(a)/sin(a), 0, 0) - (0, 0, 1e-7)), plane_patch((-90, -1, 0), (180, 0, 0), (0, 2, 0))))] == [1, 1, 1, 1]
