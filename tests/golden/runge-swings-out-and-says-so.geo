// Runge's function at eleven even places: the polynomial swings out near the ends, the spline does not.
let data = [for i in 0..10: (i - 5, 1 / (1 + (i - 5)^2))]
curve swinging = lagrange(data)
curve calm = interpolate(data, parameters = "uniform")
check swinging(0.95).y ~= 1.5787209904 within 1e-10          // by hand, in fractions
check max([for t in linspace(0, 1, 401): calm(t).y]) ~= 1 within 1e-12
