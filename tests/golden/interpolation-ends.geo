// What each end condition promises, on points of a cubic and on others.
let data = [(0, 0), (1, 2), (3, 3), (4, 1), (6, 0)]
let at = [0, 1, 2, 3, 4]
fn cubic(t) = (t, t^3 - 2*t^2 + 1)
let sampled = [for t in at: cubic(t)]

curve natural = interpolate(data, ends = "natural", parameters = at)
check derivative(natural, 0, order = 2) ~= (0, 0) within 1e-13
check derivative(natural, 4, order = 2) ~= (0, 0) within 1e-13

curve quadratic = interpolate(data, ends = "quadratic", parameters = at)
check derivative(quadratic, 0, order = 3) ~= (0, 0) within 1e-12
check derivative(quadratic, 4, order = 3) ~= (0, 0) within 1e-12

// Bessel: the tangents of the parabolas through the first and the last three points.
curve bessel = interpolate(data, parameters = at)
check derivative(bessel, 0) ~= derivative(interpolate(data[0..2], parameters = [0, 1, 2]), 0) within 1e-13
check derivative(bessel, 4) ~= derivative(interpolate(data[2..4], parameters = [2, 3, 4]), 4) within 1e-13

// Clamped: the derivatives of the literature (tridiagonal equations 1-4-1).
curve clamped = interpolate(data, parameters = at, tangents = [(1, 1), (2, -1)])
check [for t in at: derivative(clamped, t)] ~=
    [(1, 1), (13/8, 31/14), (3/2, -6/7), (11/8, -25/14), (2, -1)] within 1e-14
curve spline = cubic_spline(data, [(1, 1), (2, -1)])
check spline.points ~= clamped.points within 1e-15
check spline.domain.end == 4

// Without a knot at the second point five points of a cubic give the cubic.
curve not_a_knot = interpolate(sampled, parameters = at, ends = "not-a-knot")
check not_a_knot.knots == [0, 0, 0, 0, 2, 4, 4, 4, 4]
check [for t in linspace(0, 4, 17): not_a_knot(t)] ~= [for t in linspace(0, 4, 17): cubic(t)] within 1e-13

// Averaged: NURBS Book (9.8).
curve averaged = interpolate(data, parameters = at, ends = "averaged")
check averaged.knots == [0, 0, 0, 0, 2, 4, 4, 4, 4]
curve of_degree_two = interpolate(data, parameters = at, degree = 2)
check of_degree_two.knots == [0, 0, 0, 1.5, 2.5, 4, 4, 4]
check [for t in at: of_degree_two(t)] ~= data within 1e-14
