/// At its middle knot the path goes over from one way of bending to the other: the frame turns around there, and
/// nowhere is the section further from the path than it is wide.
let p = bspline([(0, 0, 0), (1, 2, 0), (3, -2, 0), (4, 0, 0)], degree = 2)
surface w = sweep(line((0, 0, 0.1), (0, 0.1, 0.1)), p, frame = "frenet")
check max([for v in linspace(0, 1, 2001): distance(w(0, v), p(v))]) < 0.12
check max([for v in [...linspace(0, 0.49, 200), ...linspace(0.51, 1, 200)]: abs(distance(w(0, v), p(v)) - 0.1)]) < 1e-6

/// At knots of degree 2 the frame jumps by any angle.
let q = bspline([(0, 0, 0), (1, 2, 0), (3, -2, 1), (4, 0, 0), (5, 1, 1), (3, 3, 3)], degree = 2)
surface x = sweep(line((0, 0, 0.1), (0, 0.1, 0.1)), q, frame = "frenet", tolerance = 1e-4)
check max([for v in linspace(0, 1, 2001): distance(x(0, v), q(v))]) < 0.12
