geo 1
unit mm

// From a point to a circle: the square of the length is that of the distance less that of the radius.
curves from_point = line_tangent((5, 0), circle((0, 0), 3))
check [for l in from_point: length(l)] ~= [4, 4]
check [for l in from_point: dot(l.end, l.end - l.start)] ~= [0, 0] within 1e-12
check line_tangent((5, 0), circle((0, 0), 3), near = (2, -2)).end ~= (1.8, -2.4)
check line_tangent(circle((0, 0), 3), (5, 0), near = (2, -2)).start ~= (1.8, -2.4)

// Two circles at d: outside sqrt(d^2 - (r - s)^2), between them sqrt(d^2 - (r + s)^2).
curves belts = line_tangent(circle((0, 0), 2), circle((6, 0), 1))
check sort([for l in belts: length(l)]) ~= [sqrt(27), sqrt(27), sqrt(35), sqrt(35)]
check len(line_tangent(circle((0, 0), 1), circle((1, 0), 1))) == 2
// The tangent in the place where circles touch has no length.
check len(line_tangent(circle((0, 0), 1), circle((2, 0), 1))) == 2
// Half a circle has half of them.
check len(line_tangent((5, 0), arc((0, 0), 3, 0deg, 180deg))) == 1

// y = x^2 is touched from (0, -1) at x = -1 and 1; by y = -x^2 - 1 along lines of the length sqrt(6).
curve parabola = bezier((-2, 4), (0, -4), (2, 4))
check [for l in line_tangent((0, -1), parabola): l.end] ~= [(-1, 1), (1, 1)]
check [for l in line_tangent(parabola, bezier((-2, -5), (0, 3), (2, -5))): length(l)] ~= [sqrt(6), sqrt(6)]
// The polar of (4, 0) in an ellipse with half axes of 2 and 1 is x = 1.
check [for l in line_tangent((4, 0), ellipse((0, 0), 2, 1)): l.end.x] ~= [1, 1]
// The tangent of y = x^3 where it bends over comes from the point (-1, 0) as well as the one at x = -3/2.
curve cubic = bezier((-2, -8), (-2/3, 8), (2/3, -8), (2, 8))
check [for l in line_tangent((-1, 0), cubic): l.end.x] ~= [-1.5, 0] within 1e-6
// In any plane.
let up = 35deg
curves tilted = line_tangent(rotate((5, 0), up, axis = (1, 2, 0)), rotate(circle((0, 0), 3), up, axis = (1, 2, 0)))
check [for l in tilted: length(l)] ~= [4, 4]

// Between the legs of a right angle, and in the four quarters around a cross.
curve x = line((-9, 0), (9, 0))
curve y = line((0, -9), (0, 9))
check len(arc_tangent(x, y, 2)) == 4
curve corner = arc_tangent(x, y, 2, near = (1, 1))
check corner.start ~= (2, 0) and corner.end ~= (0, 2) and length(corner) ~= pi
check length(arc_tangent(x, y, 2, near = (-5, -5), long = true)) ~= 3*pi

// A circle of radius r + 1 or r - 1 about each centre has the centres of what touches both.
check len(arc_tangent(circle((0, 0), 1), circle((4, 0), 1), 4)) == 8
check len(arc_tangent(circle((0, 0), 1), circle((4, 0), 1), 2.5)) == 6
// One fits between them: half a turn.
curves between = arc_tangent(circle((0, 0), 1), circle((4, 0), 1), 1)
check len(between) == 1 and length(between[0]) ~= pi
// Beside a line and a circle: the centre is at (sqrt(5), 2).
check [for a in arc_tangent(x, circle((0, 4), 1), 2): abs(a.start.x)] ~= [sqrt(5), sqrt(5)]
// Through a point.
check arc_tangent((0, 0), line((-5, 2), (5, 2)), 2, near = (3, 1)).end ~= (2, 2)
// Beside a curve that is none of these: its nearest point to the centre is as far as the radius.
curves beside = arc_tangent(parabola, line((-3, -1), (3, -1)), 1.5)
check every([for a in beside: closest(parabola, center_of_curvature(a, 0.5)).distance ~= 1.5 within 1e-9])
print belts[0], corner, len(beside)
