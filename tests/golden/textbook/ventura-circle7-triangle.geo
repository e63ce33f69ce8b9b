// Ventura: Full unit circle (p.18: 7 points on a triangle, 3 arcs of 120 deg)
geo 1
curve c = circle((0, 0), 1, form = "7-triangle")
check c.knots ~= [0, 0, 0, 1/3, 1/3, 2/3, 2/3, 1, 1, 1] within 1e-12
check c.weights ~= [1, 1/2, 1, 1/2, 1, 1/2, 1] within 1e-12
check len(c.points) == 7
check c(0) ~= (1, 0, 0) within 1e-12
check norm(c(0)) ~= 1 within 1e-12
check derivative(c, 0) ~= (0, 5.1961524227066319, 0) within 5.2e-12
check c(0.1) ~= (0.82911392405063291, 0.55907969105071356, 0) within 1e-12
check norm(c(0.1)) ~= 1 within 1e-12
check derivative(c, 0.1) ~= (-3.6772953052395449, 5.4534206647537957, 0) within 5.45e-12
check c(1/3) ~= (-0.5, 0.86602540378443865, 0) within 1e-12
check norm(c(1/3)) ~= 1 within 1e-12
check derivative(c, 1/3) ~= (-4.5, -2.5980762113533159, 0) within 4.5e-12
check c(1/2) ~= (-1, 0, 0) within 1e-12
check norm(c(1/2)) ~= 1 within 1e-12
check derivative(c, 1/2) ~= (0, -6.9282032302755092, 0) within 6.93e-12
check c(0.77) ~= (0.091527795445872026, -0.99580252191929028, 0) within 1e-12
check norm(c(0.77)) ~= 1 within 1e-12
check derivative(c, 0.77) ~= (6.5822944750137312, 0.60500238652978623, 0) within 6.58e-12
check c(1) ~= (1, 0, 0) within 1e-12
check norm(c(1)) ~= 1 within 1e-12
check derivative(c, 1) ~= (0, 5.1961524227066319, 0) within 5.2e-12
check continuity(trim(c, 0..1/3), trim(c, 1/3..1)).c == 1
check continuity(trim(c, 0..1/3), trim(c, 1/3..1)).c_homogeneous == 0
check continuity(trim(c, 0..2/3), trim(c, 2/3..1)).c == 1
check continuity(trim(c, 0..2/3), trim(c, 2/3..1)).c_homogeneous == 0
check length(c) ~= 6.2831853071795865 within 6.28e-12
// the same circle from its control points, weights and knots
curve spelt_out = nurbs([
  (1, 0), (1, 1.7320508075688772), (-0.5, 0.8660254037844386), (-2, 0), (-0.5, -0.8660254037844386),
  (1, -1.7320508075688772), (1, 0),
], weights = [1, 1/2, 1, 1/2, 1, 1/2, 1], degree = 2, knots = [0, 0, 0, 1/3, 1/3, 2/3, 2/3, 1, 1, 1])
check [for t in linspace(0, 1, 13): c(t)] ~= [for t in linspace(0, 1, 13): spelt_out(t)] within 1e-12
