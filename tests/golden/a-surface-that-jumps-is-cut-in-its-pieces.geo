// An inner knot as often as the order: the surface breaks there, and so do its lines.
geo 1

let knots = [0, 0, 0, 1, 1, 1, 2, 2, 2]
curve profile = bspline([(0, 0), (1, 1), (2, 0), (5, 4), (6, 5), (7, 4)], degree = 2, knots = knots)
surface wall = extrude(profile, (0, 0, 1))

let level = section(wall, plane((0, 0, 0.5), (0, 0, 1)))
check len(level) == 2
check sum([for line in level: length(line)]) ~= length(profile) within 1e-5
let heights = contours(wall, (0, 0, 1), [0.25, 0.75])
check len(heights) == 4

// A plane that crosses one of the pieces, and one between them.
check len(section(wall, plane((0.5, 0, 0), (1, 0, 0)))) == 1
check len(section(wall, plane((3.5, 0, 0), (1, 0, 0)))) == 0
check len(intersect(line((-1, 0.2, 0.5), (9, 0.2, 0.5)), wall)) == 2
check len(intersect(wall, plane_patch((5.5, 3, -1), (0, 3, 0), (0, 0, 3)))) == 1
