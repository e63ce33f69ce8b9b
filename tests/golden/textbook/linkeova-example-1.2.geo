// Linkeová: Ellipse: first three derivatives at t=i*pi/3 (Example 1.2, table p.15)
geo 1
curve c = parametric(t => (4*cos(t), 3*sin(t)), 0..2*pi)
check c(0) ~= (4, 0, 0) within 4e-12
check derivative(c, 0) ~= (0, 3, 0) within 3e-12
check derivative(c, 0, order = 2) ~= (-4, 0, 0) within 4e-12
check derivative(c, 0, order = 3) ~= (0, -3, 0) within 3e-12
check c(pi/3) ~= (2, 2.5980762113533159, 0) within 2.6e-12
check derivative(c, pi/3) ~= (-3.4641016151377546, 1.5, 0) within 3.46e-12
check derivative(c, pi/3, order = 2) ~= (-2, -2.5980762113533159, 0) within 2.6e-12
check derivative(c, pi/3, order = 3) ~= (3.4641016151377546, -1.5, 0) within 3.46e-12
check c(2*pi/3) ~= (-2, 2.5980762113533159, 0) within 2.6e-12
check derivative(c, 2*pi/3) ~= (-3.4641016151377546, -1.5, 0) within 3.46e-12
check derivative(c, 2*pi/3, order = 2) ~= (2, -2.5980762113533159, 0) within 2.6e-12
check derivative(c, 2*pi/3, order = 3) ~= (3.4641016151377546, 1.5, 0) within 3.46e-12
check c(3*pi/3) ~= (-4, 0, 0) within 4e-12
check derivative(c, 3*pi/3) ~= (0, -3, 0) within 3e-12
check derivative(c, 3*pi/3, order = 2) ~= (4, 0, 0) within 4e-12
check derivative(c, 3*pi/3, order = 3) ~= (0, 3, 0) within 3e-12
check c(4*pi/3) ~= (-2, -2.5980762113533159, 0) within 2.6e-12
check derivative(c, 4*pi/3) ~= (3.4641016151377546, -1.5, 0) within 3.46e-12
check derivative(c, 4*pi/3, order = 2) ~= (2, 2.5980762113533159, 0) within 2.6e-12
check derivative(c, 4*pi/3, order = 3) ~= (-3.4641016151377546, 1.5, 0) within 3.46e-12
check c(5*pi/3) ~= (2, -2.5980762113533159, 0) within 2.6e-12
check derivative(c, 5*pi/3) ~= (3.4641016151377546, 1.5, 0) within 3.46e-12
check derivative(c, 5*pi/3, order = 2) ~= (-2, 2.5980762113533159, 0) within 2.6e-12
check derivative(c, 5*pi/3, order = 3) ~= (-3.4641016151377546, -1.5, 0) within 3.46e-12
check c(6*pi/3) ~= (4, 0, 0) within 4e-12
check derivative(c, 6*pi/3) ~= (0, 3, 0) within 3e-12
check derivative(c, 6*pi/3, order = 2) ~= (-4, 0, 0) within 4e-12
check derivative(c, 6*pi/3, order = 3) ~= (0, -3, 0) within 3e-12
