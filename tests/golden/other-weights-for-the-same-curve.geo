// The NURBS Book, (10.15).
curve c = bezier((1, 0), (1, 1), (0, 1), weights = [1, sqrt(2)/2, 1])
curve smoothed = reweight(c, line((1, 0), (3, 0)))
check smoothed.weights ~= [1, 1.4714045207910317, 1.7475468957064284, 3] within 1e-15
check smoothed.points ~= [(1, 0), (1, 0.32037724101704074), (0.80925643016945381, 1), (0, 1)] within 1e-15
check [for t in linspace(0, 1, 9): c(t)] ~= [for t in linspace(0, 1, 9): smoothed(t)] within 1e-15

// A factor with knots of its own brings them along.
curve kinked = reweight(c, bspline([(1, 0), (2, 0), (1, 0)], degree = 1))
check kinked.degree == 3
check kinked.knots == [0, 0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1, 1]
check kinked(0.3) ~= c(0.3) within 1e-15
