// Vukašinović, Duhovnik: NURBS: weights, zero weight, weight pulls the curve ((1.20)-(1.22))
geo 1
let ctrl = [(0, 0), (1, 3), (3, 4), (4, 1), (6, 0), (7, 3), (9, 2)]
let knot_vector = [0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4]
let w0 = [1, 1, 1, 1/3, 1, 1, 1]
curve c0 = nurbs(ctrl, weights = w0, degree = 3, knots = knot_vector)
check [for i in 0..6: nurbs([for j in 0..6: (if i == j then 1 else 0, j)], weights = w0, degree = 3, knots = knot_vector)(2).x] ~= [0, 0, 3/10, 2/5, 3/10, 0, 0] within 1e-12
check c0(2) ~= (43/10, 8/5, 0) within 4.3e-12
check derivative(c0, 2) ~= (27/10, -18/5, 0) within 3.6e-12
check derivative(c0, 3/2, order = 2) ~= (181224/117649, -614088/117649, 0) within 5.22e-12
let w1 = [1, 1, 1, 1, 1, 1, 1]
curve c1 = nurbs(ctrl, weights = w1, degree = 3, knots = knot_vector)
check [for i in 0..6: nurbs([for j in 0..6: (if i == j then 1 else 0, j)], weights = w1, degree = 3, knots = knot_vector)(2).x] ~= [0, 0, 1/6, 2/3, 1/6, 0, 0] within 1e-12
check c1(2) ~= (25/6, 4/3, 0) within 4.17e-12
check derivative(c1, 2) ~= (3/2, -2, 0) within 2e-12
check derivative(c1, 3/2, order = 2) ~= (-1/2, -5/4, 0) within 1.25e-12
let w2 = [1, 1, 1, 3, 1, 1, 1]
curve c2 = nurbs(ctrl, weights = w2, degree = 3, knots = knot_vector)
check [for i in 0..6: nurbs([for j in 0..6: (if i == j then 1 else 0, j)], weights = w2, degree = 3, knots = knot_vector)(2).x] ~= [0, 0, 1/14, 6/7, 1/14, 0, 0] within 1e-12
check c2(2) ~= (57/14, 8/7, 0) within 4.07e-12
check derivative(c2, 2) ~= (9/14, -6/7, 0) within 1e-12
check derivative(c2, 3/2, order = 2) ~= (-156168/103823, 183528/103823, 0) within 1.77e-12
