// Vukašinović, Duhovnik: Cubic B-spline basis on {0,0,0,0,1,2,3,4,4,4,4} (Example (1.19), Fig 1.16-1.17)
geo 1
let knot_vector = [0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4]
curve c = bspline([for i in 0..6: (i, i^2)], degree = 3, knots = knot_vector)
check len(c.points) == 7
check len(c.knots) == 11
check len(decompose(c)) == 4
check [for i in 0..6: bspline([for j in 0..6: (if i == j then 1 else 0, j)], degree = 3, knots = knot_vector)(0).x] ~= [1, 0, 0, 0, 0, 0, 0] within 1e-12
check [for i in 0..6: bspline([for j in 0..6: (if i == j then 1 else 0, j)], degree = 3, knots = knot_vector)(0.5).x] ~= [1/8, 19/32, 25/96, 1/48, 0, 0, 0] within 1e-12
check [for i in 0..6: bspline([for j in 0..6: (if i == j then 1 else 0, j)], degree = 3, knots = knot_vector)(1).x] ~= [0, 1/4, 7/12, 1/6, 0, 0, 0] within 1e-12
check [for i in 0..6: bspline([for j in 0..6: (if i == j then 1 else 0, j)], degree = 3, knots = knot_vector)(1.5).x] ~= [0, 1/32, 15/32, 23/48, 1/48, 0, 0] within 1e-12
check [for i in 0..6: bspline([for j in 0..6: (if i == j then 1 else 0, j)], degree = 3, knots = knot_vector)(2).x] ~= [0, 0, 1/6, 2/3, 1/6, 0, 0] within 1e-12
check [for i in 0..6: bspline([for j in 0..6: (if i == j then 1 else 0, j)], degree = 3, knots = knot_vector)(3.5).x] ~= [0, 0, 0, 1/48, 25/96, 19/32, 1/8] within 1e-12
check [for i in 0..6: bspline([for j in 0..6: (if i == j then 1 else 0, j)], degree = 3, knots = knot_vector)(4).x] ~= [0, 0, 0, 0, 0, 0, 1] within 1e-12
check [for i in 0..6: derivative(bspline([for j in 0..6: (if i == j then 1 else 0, j)], degree = 3, knots = knot_vector), 1/2).x] ~= [-3/4, -3/16, 13/16, 1/8, 0, 0, 0] within 1e-12
check [for i in 0..6: derivative(bspline([for j in 0..6: (if i == j then 1 else 0, j)], degree = 3, knots = knot_vector), 5/2, order = 2).x] ~= [0, 0, 1/2, -1/2, -3/4, 3/4, 0] within 1e-12
check reparametrize(c, 0..1).knots ~= [0, 0, 0, 0, 1/4, 1/2, 3/4, 1, 1, 1, 1] within 1e-12
