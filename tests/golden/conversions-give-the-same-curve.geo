// Linkeova, (2.53), Exercise 2.27: one curve in four forms.
curve k = clamped((-5, 4), (-6, 4), (-6, 0), (0, -6), (6, 0), (6, 4), (5, 4))
curve coons = to_coons(k)
check coons.points ~= [(0, 0), (-6, 6), (-6, 0), (0, -6), (6, 0), (6, 6), (0, 0)] within 1e-12
check to_clamped(coons).points ~= k.points within 1e-12
check to_clamped(coons).knots ~= [0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4] within 1e-12
let ferguson_data = to_hermite(coons)
curve chain = hermite(ferguson_data.points, ferguson_data.tangents)
check to_clamped(chain).points ~= k.points within 1e-12
check to_coons(chain).points ~= coons.points within 1e-12
let pieces = to_bezier(chain)
check [for t in linspace(0, 4, 33): chain(t)] ~= [for t in linspace(0, 4, 33): k(t)] within 1e-12
check [for i in 0..3: pieces[i].points[0]] ~= knot_points(k)[0..3] within 1e-12

// A Bezier cubic as a Coons cubic, Exercise 2.16, and back.
curve b = bezier((-2, 1), (0, 0), (1, 3), (2, 2))
check to_coons(b).points ~= [(-10, 12), (-1, -3), (2, 6), (5, -9)] within 1e-12
check to_clamped(to_coons(b)).points ~= b.points within 1e-12

// The power basis and back, over any domain.
let coefficients = [(1, 0, 2), (-1, 3, 1), (9, 2, -12), (-5, -3, 9)]
check power_coefficients(polynomial(coefficients)) ~= coefficients within 1e-12
check power_coefficients(polynomial(coefficients, domain = -1..3)) ~= coefficients within 1e-12
check polynomial(coefficients, domain = -1..3)(2) ~= (-5, -10, 28) within 1e-12

// Knots that are not needed go, also with weights.
curve arc9 = circle((0, 0), 2)
check to_clamped(arc9).knots == arc9.knots
