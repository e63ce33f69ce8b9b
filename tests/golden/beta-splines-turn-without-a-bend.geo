// Barsky's Beta-spline: values of the rational arithmetic of its basis.
let ctrl = [(0, 0), (1, 2), (3, 2), (4, 0), (6, 1)]
curve c0 = beta_spline(ctrl, bias = 1, tension = 0)
check c0.domain == 0..2
check c0(1/3) ~= (277/162, 17/9) within 1e-13
check derivative(c0, 4/3) ~= (23/18, -25/18) within 1e-13
curve c1 = beta_spline(ctrl, bias = 2, tension = 0)
check c1(0) ~= (5/7, 26/21) within 1e-13
check derivative(c1, 0) ~= (12/7, 16/7) within 1e-13
check c1(1/3) ~= (242/189, 1004/567) within 1e-13
check derivative(c1, 1/3) ~= (5/3, 62/63) within 1e-13

// Without bias and tension it is the Coons B-spline.
check [for i in 0..8: c0(i/4)] ~= [for i in 0..8: coons_bspline(ctrl)(i/4)] within 1e-13

// The derivative behind a joint is bias times that before it, the curvature is one.
check derivative(c1, 1) ~= 2*derivative(to_bezier(c1)[0], 1) within 1e-13
check curvature(to_bezier(c1)[0], 1) ~= curvature(to_bezier(c1)[1], 1) within 1e-13
check beta_spline(ctrl, bias = 1/2, tension = 10, closed = true).closed
