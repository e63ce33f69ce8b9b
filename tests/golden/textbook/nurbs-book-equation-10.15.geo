// The NURBS Book: Smoothing function f(u)C^w(u): the projected curve is unchanged ((10.15))
geo 1
curve c = bezier((1, 0), (1, 1), (0, 1), weights = [1, sqrt(2)/2, 1])
curve smoothed = bezier([(1, 0), (1, 0.32037724101704074), (0.80925643016945381, 1), (0, 1)], weights = [1, 1.4714045207910317, 1.7475468957064284, 3])
check c(1/5) ~= (0.95586324610697424, 0.29381193771158787, 0) within 1e-12
check smoothed(1/5) ~= (0.95586324610697424, 0.29381193771158787, 0) within 1e-12
check c(1/2) ~= (0.70710678118654752, 0.70710678118654752, 0) within 1e-12
check smoothed(1/2) ~= (0.70710678118654752, 0.70710678118654752, 0) within 1e-12
check [for t in linspace(0, 1, 9): c(t)] ~= [for t in linspace(0, 1, 9): smoothed(t)] within 1e-12
