curve c = nurbs([(1, 0), (1, 1), (0, 1)], weights = [1, sqrt(2)/2, 1], degree = 2, knots = [0, 0, 0, 1, 1, 1])
print c.domain, c.degree, c.knots, c.weights, c.points, c.start, c.end, c.closed, c.rational, c.segments
check norm(c(0.3)) ~= 1 within 1e-15 "a quarter of the unit circle"
check c(0.5) ~= (sqrt(2)/2, sqrt(2)/2)
curve ring = circle((0, 0), 1)
print ring.segments, ring.degree, len(ring.points)
check ring.start ~= ring.end
curve path = polyline((0, 0), (1, 0), (1, 2))
check path.domain.end == 2 "one unit of parameter a leg"
check path(1.5) == (1, 1)
