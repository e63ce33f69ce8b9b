// The NURBS Book: 9-point circle: C1 in 3D, homogeneous curve only C0 at the double knots (Sec 10.3 third bullet (Ex7.2))
geo 1
curve c = circle((0, 0), 1)
check continuity(trim(c, 0..0.25), trim(c, 0.25..1)).c == 1
check continuity(trim(c, 0..0.25), trim(c, 0.25..1)).c_homogeneous == 0
check continuity(trim(c, 0..0.5), trim(c, 0.5..1)).c == 1
check continuity(trim(c, 0..0.5), trim(c, 0.5..1)).c_homogeneous == 0
check continuity(trim(c, 0..0.75), trim(c, 0.75..1)).c == 1
check continuity(trim(c, 0..0.75), trim(c, 0.75..1)).c_homogeneous == 0
