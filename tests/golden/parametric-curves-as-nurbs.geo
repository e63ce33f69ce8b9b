// A function as a spline: within the tolerance at every parameter, and C2.
curve helix_of = parametric(t => (2 * cos(t), 2 * sin(t), 0.3 * t), 0..12)
curve spline = to_nurbs(helix_of, 1e-7)
check every(linspace(0, 12, 1000), f = t => distance(spline(t), (2 * cos(t), 2 * sin(t), 0.3 * t)) < 1e-7)
check continuity(spline).c >= 2
check spline.domain.end == 12 and spline.degree == 5
check curvature(spline, 5) ~= 2 / (2^2 + 0.3^2) within 1e-5
check length(spline) ~= 12 * sqrt(4 + 0.09) within 1e-6

// Polynomials up to the fifth power are met exactly, and a NURBS stays what it is.
curve quintic = to_nurbs(parametric(t => (t, t^5 - t, 2 * t^3), -1..2), 1e-9)
check quintic.segments == 1 and quintic(0.7) ~= (0.7, 0.7^5 - 0.7, 2 * 0.7^3) within 1e-13
check to_nurbs(circle((0, 0), 1), 1e-3) == circle((0, 0), 1)
export spline to "spline.obj"
