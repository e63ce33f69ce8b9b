// Linkeová: Ellipse points at NORMALISED parameter i/6 (= i*pi/3), curvature comb (Exercise 1.1)
geo 1
curve c = parametric(t => (4*cos(t), 3*sin(t)), 0..2*pi)
check c(0) ~= (4, 0, 0) within 4e-12
check curvature(c, 0) ~= 0.44444444444444444 within 1e-12
check c(2*pi*1/6) ~= (2, 2.5980762113533159, 0) within 2.6e-12
check curvature(c, 2*pi*1/6) ~= 0.22307913382148106 within 1e-12
check c(2*pi*2/6) ~= (-2, 2.5980762113533159, 0) within 2.6e-12
check curvature(c, 2*pi*2/6) ~= 0.22307913382148106 within 1e-12
check c(2*pi*3/6) ~= (-4, 0, 0) within 4e-12
check curvature(c, 2*pi*3/6) ~= 0.44444444444444444 within 1e-12
check c(2*pi*4/6) ~= (-2, -2.5980762113533159, 0) within 2.6e-12
check curvature(c, 2*pi*4/6) ~= 0.22307913382148106 within 1e-12
check c(2*pi*5/6) ~= (2, -2.5980762113533159, 0) within 2.6e-12
check curvature(c, 2*pi*5/6) ~= 0.22307913382148106 within 1e-12
