// Lengths to the last digits, places at the ends of the range of numbers, and zeros that are zeros.
geo 1

// A leg is as long as its ends are apart, whatever its weights.
check length(nurbs([(0, 0), (3, 4)], weights = [1, 1e6], degree = 1)) == 5
check length(nurbs([(0, 0), (3e-4, 4e-4), (3e-4, 0)], weights = [1, 7, 3], degree = 1)) ~= 9e-4 within 2e-19
check length(nurbs([(0, 0), (3, 4)], weights = [1, 2], degree = 1), range = 0..0.5) ~= 10 / 3 within 1e-15

// Far from the origin the length is that of the curve, not of its place.
curve wave = bezier((0, 0), (1, 2), (2, -2), (3, 0))
check length(translate(wave, (2^20, 2^21))) ~= length(wave) within 1e-13

curve long = line((0, 0), (1e308, 1e308))
let thirds = divide(long, 4)
check thirds[1].x / 1e308 ~= 0.25 within 1e-12
check thirds[3].x / 1e308 ~= 0.75 within 1e-12
check parameter_at_length(line((0, 0), (1e308, 0)), 1e307) ~= 0.1 within 1e-12
check parameter_at_length(line((0, 0), (1e-200, 0)), 1e-201) ~= 0.1 within 1e-12

// At a cusp the curvature has no bound: no vertex, whichever kind the curve is.
check vertices(polynomial((0, 0), (0, 0), (1, 0), (0, 1), domain = -0.5..0.5)) == []
check vertices(parametric(t => (t^2, t^3), domain = -0.5..0.5)) == []

// What is zero but for the rounding of a domain's ends is zero.
curve bend = polynomial((0, 0), (1, 0), (0, 0), (0, 1), domain = -1..2)
check inflections(bend) == [0]
check closest(polynomial((0, 0), (1, 0), (0, 1), domain = -1..2), (0, -1)).t == 0

// Heavy weights crowd the curve to the ends of its domain: both feet of the mirror image count.
check closest(nurbs([(-1, 0), (-1, 2), (1, 2), (1, 0)], weights = [1, 1e8, 1e8, 1], degree = 3), (0, 0.5)).count == 2
curve heavy = nurbs([(-76, 52), (-5, -24), (-58, -2), (79, -22)], weights = [10, 1000, 1000, 0.001], degree = 3)
check length(heavy, range = 0..0.37) + length(heavy, range = 0.37..1) ~= length(heavy) within 1e-10

// Another parameter of the same points: weights of one at both ends.
curve quarter = nurbs([(1, 0), (1, 1), (0, 1)], weights = [1, 1, 2], degree = 2)
curve even = standard_form(quarter)
check even.weights ~= [1, sqrt(1/2), 1] within 1e-15
check even(0.5) ~= (sqrt(1/2), sqrt(1/2)) within 1e-15
curve c = nurbs([(0, 0), (1, 3), (3, 3), (4, 0), (6, 1), (7, 4)], weights = [3, 1, 2, 5, 1, 0.2], degree = 3)
curve s = standard_form(c)
check s.weights[0] == 1 and s.weights[-1] == 1
check s.domain == c.domain
check length(s) ~= length(c) within 1e-12
check every(sample(s, 33), p => closest(c, p).distance <= 1e-13)

// What kind of knots a curve has, now and after an edit.
check knot_class(bezier((0, 0), (1, 2), (2, 0))).class == "bezier"
check knot_class(bspline([(0, 0), (1, 2), (2, 0), (3, 1), (4, 0)])).class == "uniform clamped"
check describe(insert_knot(bspline([(0, 0), (1, 2), (2, 0), (3, 1), (4, 0)]), 0.25)).knot_class == "clamped"
check knot_class(bspline([(0, 0), (1, 2), (2, 0), (3, 1)], closed = true)).periodic
check knot_class(bspline([(0, 0), (1, 2), (2, 0), (3, 1)], degree = 2, knots = [0, 1, 2, 4, 5, 6, 9])).class == "unclamped"
check knot_class(circle((0, 0), 1)).bezier
