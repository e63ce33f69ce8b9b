// A line, then a quarter circle: the curvature jumps at the knot, the tangent does not.
let h = sqrt(2)/2
curve c = nurbs([(-2, 0), (-1, 0), (0, 0), (1, 0), (1, 1)], weights = [1, 1, 1, h, 1], degree = 2, knots = [0, 0, 0, 1, 1, 2, 2, 2])
check curvature(c, 1, side = "left") == 0
check curvature(c, 1) ~= 1 within 1e-15 "the right side, unless told otherwise"
check normal(c, 1) ~= (0, 1) within 1e-15
check derivative(c, 1, order = 2, side = "left") == (0, 0)
check derivative(c, 1, order = 2) != (0, 0)
check center_of_curvature(c, 1) ~= (0, 1) within 1e-15
print classify(c, 1), continuity(c).g

// A corner.
curve corner = polyline((0, 0), (1, 0), (1, 1))
print tangent(corner, 1), tangent(corner, 1, side = "left"), classify(corner, 1)
// At the end there is the left side only.
check tangent(corner, 2) == tangent(corner, 2, side = "left")
