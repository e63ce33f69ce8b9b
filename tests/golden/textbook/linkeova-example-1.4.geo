// Linkeová: Ellipse: curvature, radius, osculating circles (Example 1.4, (1.26)-(1.27), Fig 1.5-1.6)
geo 1
curve c = parametric(t => (4*cos(t), 3*sin(t)), 0..2*pi)
check curvature(c, 0) ~= 0.44444444444444444 within 1e-12
check radius_of_curvature(c, 0) ~= 2.25 within 2.25e-12
check center_of_curvature(c, 0) ~= (1.75, 0, 0) within 1.75e-12
check curvature(c, pi/2) ~= 0.1875 within 1e-12
check radius_of_curvature(c, pi/2) ~= 5.3333333333333333 within 5.33e-12
check center_of_curvature(c, pi/2) ~= (0, -2.3333333333333333, 0) within 2.33e-12
check curvature(c, pi/3) ~= 0.22307913382148106 within 1e-12
check torsion(c, pi/3) ~= 0 within 1e-12
check center_of_curvature(c, pi/3) ~= (0.21875, -1.5155444566227676, 0) within 1.52e-12
check curvature(c, 2*pi/3) ~= 0.22307913382148106 within 1e-12
check torsion(c, 2*pi/3) ~= 0 within 1e-12
check center_of_curvature(c, 2*pi/3) ~= (-0.21875, -1.5155444566227676, 0) within 1.52e-12
check length(c, range = 0..2*pi) ~= 22.103492160709505 within 2.21e-11
