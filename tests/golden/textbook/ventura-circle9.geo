// Ventura: Full unit circle (p.16: 9 points, 4 arcs of 90 deg)
geo 1
curve c = circle((0, 0), 1)
check c.knots ~= [0, 0, 0, 1/4, 1/4, 1/2, 1/2, 3/4, 3/4, 1, 1, 1] within 1e-12
check c.weights ~= [1, 0.70710678118654752, 1, 0.70710678118654752, 1, 0.70710678118654752, 1, 0.70710678118654752, 1] within 1e-12
check len(c.points) == 9
check c(0) ~= (1, 0, 0) within 1e-12
check norm(c(0)) ~= 1 within 1e-12
check derivative(c, 0) ~= (0, 5.6568542494923802, 0) within 5.66e-12
check c(0.1) ~= (0.81382603605107506, 0.58110858111491889, 0) within 1e-12
check norm(c(0.1)) ~= 1 within 1e-12
check derivative(c, 0.1) ~= (-3.824998250241574, 5.3568012331258288, 0) within 5.36e-12
check c(1/3) ~= (-0.48904167641086826, 0.87226041910271706, 0) within 1e-12
check norm(c(1/3)) ~= 1 within 1e-12
check derivative(c, 1/3) ~= (-5.6726913105966572, -3.1804520846530214, 0) within 5.67e-12
check c(1/2) ~= (-1, 0, 0) within 1e-12
check norm(c(1/2)) ~= 1 within 1e-12
check derivative(c, 1/2) ~= (0, -5.6568542494923802, 0) within 5.66e-12
check c(0.77) ~= (0.11546422932707381, -0.99331163878508184, 0) within 1e-12
check norm(c(0.77)) ~= 1 within 1e-12
check derivative(c, 0.77) ~= (5.8721921638453944, 0.68259357505181932, 0) within 5.87e-12
check c(1) ~= (1, 0, 0) within 1e-12
check norm(c(1)) ~= 1 within 1e-12
check derivative(c, 1) ~= (0, 5.6568542494923802, 0) within 5.66e-12
check continuity(trim(c, 0..0.25), trim(c, 0.25..1)).c == 1
check continuity(trim(c, 0..0.25), trim(c, 0.25..1)).c_homogeneous == 0
check continuity(trim(c, 0..0.5), trim(c, 0.5..1)).c == 1
check continuity(trim(c, 0..0.5), trim(c, 0.5..1)).c_homogeneous == 0
check continuity(trim(c, 0..0.75), trim(c, 0.75..1)).c == 1
check continuity(trim(c, 0..0.75), trim(c, 0.75..1)).c_homogeneous == 0
check length(c) ~= 6.2831853071795865 within 6.28e-12
// the same circle from its control points, weights and knots
curve spelt_out = nurbs([(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)], weights = [1, sqrt(2)/2, 1, sqrt(2)/2, 1, sqrt(2)/2, 1, sqrt(2)/2, 1], degree = 2, knots = [0, 0, 0, 1/4, 1/4, 1/2, 1/2, 3/4, 3/4, 1, 1, 1])
check [for t in linspace(0, 1, 13): c(t)] ~= [for t in linspace(0, 1, 13): spelt_out(t)] within 1e-12
