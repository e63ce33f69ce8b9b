// An inner knot that stands degree + 1 times parts a curve into two: from (2, 0) it jumps to (5, 4).
geo 1

let knots = [0, 0, 0, 1, 1, 1, 2, 2, 2]
curve j = bspline([(0, 0), (1, 1), (2, 0), (5, 4), (6, 5), (7, 4)], degree = 2, knots = knots)
let [a, b] = split(j, 1)

// The nearest point of either side, at a parameter where the curve is there.
let near = closest(j, (2.2, 0.1))
check near.point ~= (2, 0)
check near.distance ~= norm((0.2, 0.1)) within 1e-12
check near.t ~= 1
check j(near.t) ~= near.point within 1e-12
check closest(j, (4.9, 3.9)).point == (5, 4)
check length(j) ~= length(a) + length(b) within 1e-12
check continuity(j).c == -1
check continuity(j).gap == 5

// Nothing is between the sides, and what is at the end of one is found.
check intersect(j, line((3.5, 0), (3.5, 9))) == []
check len(intersect(j, line((0, 4.2), (9, 4.2)))) == 2
let ends = intersect(j, line((2, -1), (2, 9)))
check len(ends) == 1 and ends[0].point ~= (2, 0)
check section(j, plane((2, 0, 0), (1, 0, 0))) ~= [(2, 0)]
check len(self_intersections(bspline([(0, 0), (1, 1), (2, 0), (2, 1), (1, 0), (0, 1)], degree = 2, knots = knots))) == 1

// It turns nowhere between the sides, and is no loop.
check corners(j) == [] and cusps(j) == []
check extrema(j, (0, 1)) ~= [0.5, 1.5]
check vertices(j) ~= [0.5, 1.5]
check not bspline([(0, 0), (1, 1), (2, 0), (5, 4), (3, 5), (0, 0)], degree = 2, knots = knots).closed

// So are surfaces.
surface s = extrude(j, (0, 0, 1))
check area(s) ~= length(j) * 1mm within 1e-9
check closest(s, (2.1, 0.1, 0.5)).point ~= (2, 0, 0.5)

// Where both sides meet there is no jump, but a corner.
curve whole = bspline([(0, 0), (1, 1), (2, 0), (2, 0), (3, 5), (4, 0)], degree = 2, knots = knots)
check corners(whole) == [1]
check len(intersect(whole, line((0, 0), (9, 0)))) == 3
check len(planar_mesh(join([whole, polyline((4, 0), (4, -1), (0, 0))])).vertices) > 10
