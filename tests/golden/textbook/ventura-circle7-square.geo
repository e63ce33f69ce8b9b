// Ventura: Full unit circle (p.17: 7 points on a square, single knots 1/4 and 3/4)
geo 1
curve c = circle((0, 0), 1, form = "7-square")
check c.knots ~= [0, 0, 0, 1/4, 1/2, 1/2, 3/4, 1, 1, 1] within 1e-12
check c.weights ~= [1, 1/2, 1/2, 1, 1/2, 1/2, 1] within 1e-12
check len(c.points) == 7
check c(0) ~= (1, 0, 0) within 1e-12
check norm(c(0)) ~= 1 within 1e-12
check derivative(c, 0) ~= (0, 4, 0) within 4e-12
check c(0.1) ~= (15/17, 8/17, 0) within 1e-12
check norm(c(0.1)) ~= 1 within 1e-12
check derivative(c, 0.1) ~= (-800/289, 1500/289, 0) within 5.19e-12
check c(1/3) ~= (-3/5, 4/5, 0) within 1e-12
check norm(c(1/3)) ~= 1 within 1e-12
check derivative(c, 1/3) ~= (-144/25, -108/25, 0) within 5.76e-12
check c(1/2) ~= (-1, 0, 0) within 1e-12
check norm(c(1/2)) ~= 1 within 1e-12
check derivative(c, 1/2) ~= (0, -4, 0) within 4e-12
check c(0.77) ~= (100/629, -621/629, 0) within 1e-12
check norm(c(0.77)) ~= 1 within 1e-12
check derivative(c, 0.77) ~= (3105000/395641, 500000/395641, 0) within 7.85e-12
check c(1) ~= (1, 0, 0) within 1e-12
check norm(c(1)) ~= 1 within 1e-12
check derivative(c, 1) ~= (0, 4, 0) within 4e-12
check continuity(trim(c, 0..0.25), trim(c, 0.25..1)).c >= 2
check continuity(trim(c, 0..0.25), trim(c, 0.25..1)).c_homogeneous >= 2
check continuity(trim(c, 0..0.5), trim(c, 0.5..1)).c == 1
check continuity(trim(c, 0..0.5), trim(c, 0.5..1)).c_homogeneous == 0
check continuity(trim(c, 0..0.75), trim(c, 0.75..1)).c >= 2
check continuity(trim(c, 0..0.75), trim(c, 0.75..1)).c_homogeneous >= 2
check length(c) ~= 6.2831853071795865 within 6.28e-12
// the same circle from its control points, weights and knots
curve spelt_out = nurbs([(1, 0), (1, 1), (-1, 1), (-1, 0), (-1, -1), (1, -1), (1, 0)], weights = [1, 1/2, 1/2, 1, 1/2, 1/2, 1], degree = 2, knots = [0, 0, 0, 1/4, 1/2, 1/2, 3/4, 1, 1, 1])
check [for t in linspace(0, 1, 13): c(t)] ~= [for t in linspace(0, 1, 13): spelt_out(t)] within 1e-12
