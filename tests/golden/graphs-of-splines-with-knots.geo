// The graph of a spline's curvature and an offset by hand have corners at its knots, where one side alone has derivatives.
// Expected: integrals between the knots by an adaptive rule to 15 digits.
curve c = bspline((0, 0), (1, 2), (3, 2), (4, 0), (5, 1), (7, 3))
curve graph = parametric(t => (t, curvature(c, t) / 1mm^-1), c.domain)
curve beside = parametric(t => c(t) + 0.2 * cross((0, 0, 1), tangent(c, t)), c.domain)
check length(graph) ~= 6.283463573392216mm within 1e-11
check length(beside) ~= 9.257053647338203mm within 1e-11
curve through = interpolate([for i in 0..6: (i, sin(i * 1rad))])
check length(parametric(t => through(t) + 0.2 * cross((0, 0, 1), tangent(through, t)), through.domain)) > 6mm
