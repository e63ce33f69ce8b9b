// Places of a curve within the tolerance of a surface or a plane, each once, and small loops, by closed forms.

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

// Balls and planes that pass through one another by less than the tolerance meet in a circle of
// radius sqrt(1 - (1 - d)^2), hundreds of tolerances wide.
fn around(d) = 2*pi*sqrt(1 - (1 - d)^2)
let depths = [5e-7, 1e-7, 1e-8, 1e-10]
fn lengths(found) = [for c in found: length(c)]
check [for d in depths: lengths(intersect(sphere((0, 0, 0), 1), sphere((2 - 2*d, 0, 0), 1)))] ~= [for d in depths: [around(d)]] within 1e-7
check [for d in depths: lengths(intersect(sphere((0, 0, 0), 1), plane_patch((-5, -5, 1 - d), (10, 0, 0), (0, 10, 0))))] ~= [for d in depths: [around(d)]] within 1e-7

// A border that two patches share and the line in which they cross, from the one end of it to the other.
surface floor = plane_patch((0, 0, 0), (1, 0, 0), (0, 1, 0))
fn sorted_lengths(found) = sort(lengths(found))
check sorted_lengths(intersect(floor, bilinear((0, 0, 0), (0, 1, 0), (1, 0, -5), (1, 1, 5)))) ~= [1, 1] within 1e-6
check sorted_lengths(intersect(floor, bilinear((0, 0, 0), (0, 1, 0), (1, 0, 0), (1, 1, 1)))) ~= [1, 1] within 1e-6
check sorted_lengths(intersect(floor, ruled(line((0, 0), (0, 1)), line((1, 0, -1), (1, 1, 2))))) ~= [1, 1] within 1e-6

// A patch that ends on the line in which it touches a cylinder.
let edge = intersect(cylinder((0, 0, 0), 1, 2), plane_patch((1, 0, -1), (0, 2, 0), (0, 0, 5)))
check lengths(edge) ~= [2] within 1e-9
check every(sample(edge[0], 20), p => p.x ~= 1 within 1e-9 and p.y ~= 0 within 1e-9)
// A ball in a tube about the same axis touches it in a circle, exactly.
check lengths(intersect(sphere((0, 0, 0), 1), cylinder((0, 0, -3), 1, 6))) ~= [tau] within 1e-13
