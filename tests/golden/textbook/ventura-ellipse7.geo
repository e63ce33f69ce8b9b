// Ventura: Full ellipse = affine image of the 7-point circle (semi-axes 4, 3) (p.19)
geo 1
curve c = ellipse((0, 0), 4, 3)
curve spelt_out = nurbs([(4, 0), (4, 3), (-4, 3), (-4, 0), (-4, -3), (4, -3), (4, 0)], weights = [1, 1/2, 1/2, 1, 1/2, 1/2, 1], degree = 2, knots = [0, 0, 0, 1/4, 1/2, 1/2, 3/4, 1, 1, 1])
check closest(c, (4, 0, 0)).distance < 1e-9
check spelt_out(0) ~= (4, 0, 0) within 4e-12
check curvature(c, closest(c, (4, 0, 0)).t) ~= 4/9 within 1e-9
check curvature(spelt_out, 0) ~= 4/9 within 1e-12
check closest(c, (60/17, 24/17, 0)).distance < 1e-9
check spelt_out(0.1) ~= (60/17, 24/17, 0) within 3.53e-12
check curvature(c, closest(c, (60/17, 24/17, 0)).t) ~= 0.35018043158248988 within 1e-9
check curvature(spelt_out, 0.1) ~= 0.35018043158248988 within 1e-12
check closest(c, (0, 3, 0)).distance < 1e-9
check spelt_out(1/4) ~= (0, 3, 0) within 3e-12
check curvature(c, closest(c, (0, 3, 0)).t) ~= 3/16 within 1e-9
check curvature(spelt_out, 1/4) ~= 3/16 within 1e-12
check closest(c, (-60/17, -24/17, 0)).distance < 1e-9
check spelt_out(0.6) ~= (-60/17, -24/17, 0) within 3.53e-12
check curvature(c, closest(c, (-60/17, -24/17, 0)).t) ~= 0.35018043158248988 within 1e-9
check curvature(spelt_out, 0.6) ~= 0.35018043158248988 within 1e-12
check length(c) ~= 22.103492160709505 within 2.21e-11
