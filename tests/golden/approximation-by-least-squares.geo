// Knots of NURBS Book (9.68), (9.69); control points computed independently in 40 digits, and in fractions.
let data = [(0, 0), (1, 2), (2, 3), (4, 3), (5, 1), (7, 0), (8, 2), (9, 2), (11, 0)]
curve c = approximate(data, control_points = 6)
check c.knots ~= [0, 0, 0, 0, 0.22550820102177479, 0.62534578068176096, 1, 1, 1, 1] within 1e-15
check c.points ~= [
    (0, 0),
    (-0.093105726385595493, 0.27848796957712635),
    (3.2321266166900011, 6.6790254728603734),
    (6.6457173868669224, -4.4232406581887317),
    (9.3599555821061295, 5.2014803154822496),
    (11, 0),
] within 1e-13
curve d = approximate(data, degree = 2, control_points = 5, parameters = 0..8)
check d.knots == [0, 0, 0, 2, 5, 8, 8, 8]
check d.points ~= [
    (0, 0),
    (218819/415400, 414431/103850),
    (3970073/830800, 187677/207700),
    (7018151/830800, 425499/207700),
    (11, 0),
] within 1e-14

// What a spline of these knots can be, it becomes.
let parabola = [for t in 0..8: (t, t^2 / 4)]
check approximate(parabola, degree = 2, control_points = 5, parameters = 0..8)(2.6) ~= (2.6, 1.69) within 1e-14
// As many control points as points pass through them.
curve all = approximate(data, control_points = 9, parameters = 0..8)
check [for t in 0..8: all(t)] ~= data within 1e-13
