// The NURBS Book: Spine-tangent controlled skinning ((10.10)-(10.13), (9.22), (9.23))
geo 1
curve section0 = bezier((0, 0, 0), (1, 0, 2), (3, 0, 0))
curve section1 = bezier((0, 1, 1), (1, 2, 3), (3, 1, 0))
curve section2 = bezier((0, 4, 0), (2, 4, 2), (4, 4, 1))
curve section3 = bezier((0, 6, 1), (1, 6, 1), (3, 7, 0))
curve spine = bezier((0, 0, 0), (0, 2, 3), (0, 5, 3), (0, 7, 1))
surface s = skin([section0, section1, section2, section3], degree = 3, spine = spine, at = [0, 1/4, 3/5, 1])
check norm(cross(unit_vector(derivative(s, 1/3, 0, du = 0, dv = 1)), tangent(spine, 0))) ~= 0 within 1e-7
check norm(cross(unit_vector(derivative(s, 1/3, 1, du = 0, dv = 1)), tangent(spine, 1))) ~= 0 within 1e-7
