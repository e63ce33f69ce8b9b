// Knots of NURBS Book (9.22) and (9.23).
let data = [(0, 0), (1, 1), (3, 0), (4, 2)]
let slopes = [(1, 1), (1, 0), (1, -1), (0, 2)]
let at = [0, 1, 3, 4]
curve two = interpolate(data, degree = 2, derivatives = slopes, parameters = at)
check two.knots ~= [0, 0, 0, 0.5, 1, 2, 3, 3.5, 4, 4, 4] within 1e-15
curve three = interpolate(data, derivatives = slopes, parameters = at)
check three.knots ~= [0, 0, 0, 0, 0.5, 5/3, 7/3, 3.5, 4, 4, 4, 4] within 1e-15
check [for c in [two, three]: [for t in at: c(t)]] ~= [data, data] within 1e-13
check [for c in [two, three]: [for t in at: derivative(c, t)]] ~= [slopes, slopes] within 1e-13
