// Linkeová: Ellipse: points, coinciding end points (Example 1.1)
geo 1
curve c = parametric(t => (4*cos(t), 3*sin(t)), 0..2*pi)
check c(0) ~= (4, 0, 0) within 4e-12
check c(2*pi/3) ~= (-2, 2.5980762113533159, 0) within 2.6e-12
check c(2*pi) ~= (4, 0, 0) within 4e-12
check is_closed(c)
