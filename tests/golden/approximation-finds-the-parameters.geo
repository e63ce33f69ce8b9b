// Points of a parabola, by lengths: along a parabola those are no quadratic function, and a curve
// of three control points is only found if the points slide along it.
let data = [for s in linspace(0, 1, 21): (s, s * s)]
curve parabola = approximate(data, degree = 2, tolerance = 1e-9)
check len(parabola.points) == 3
check norm(parabola.points[1] - (0.5, 0)) < 1e-6
