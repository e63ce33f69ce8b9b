// The NURBS Book: Spine-tangent controlled skinning ((10.10)-(10.13), (9.22), (9.23))
geo 1
curve section0 = bezier((0, 0, 0), (1, 0, 2), (3, 0, 0))
curve section1 = bezier((0, 1, 1), (1, 2, 3), (3, 1, 0))
curve section2 = bezier((0, 4, 0), (2, 4, 2), (4, 4, 1))
curve section3 = bezier((0, 6, 1), (1, 6, 1), (3, 7, 0))
curve spine = bezier((0, 0, 0), (0, 2, 3), (0, 5, 3), (0, 7, 1))
surface s = skin([section0, section1, section2, section3], degree = 3, spine = spine, at = [0, 1/4, 3/5, 1])
check [for u in linspace(0, 1, 5): s(_, 0)(u)] ~= [for u in linspace(0, 1, 5): section0(u)] within 1e-10
check [for u in linspace(0, 1, 5): s(_, 1)(u)] ~= [for u in linspace(0, 1, 5): section3(u)] within 1e-10
check norm(cross(unit_vector(derivative(s, 1/3, 0, du = 0, dv = 1)), tangent(spine, 0))) ~= 0 within 1e-7
check norm(cross(unit_vector(derivative(s, 1/3, 1, du = 0, dv = 1)), tangent(spine, 1))) ~= 0 within 1e-7
surface quadratic = skin([section0, section1, section2, section3], degree = 2, spine = spine, at = [0, 1/4, 3/5, 1])
check quadratic.knots_v ~= [0, 0, 0, 1/8, 1/4, 17/40, 3/5, 4/5, 1, 1, 1] within 1e-15
check s.knots_v ~= [0, 0, 0, 0, 1/8, 11/30, 29/60, 4/5, 1, 1, 1, 1] within 1e-15
check quadratic(1/3, 1/2) ~= (1.24263038548752834, 3.2827718776825753, 1.22587984867746598) within 1e-13
check s(1/3, 1/2) ~= (1.24004920050258054, 3.27690023363005747, 1.2386200019137402) within 1e-13
check derivative(s, 1/3, 1/4, du = 0, dv = 1) ~= (0, 6.48029764259110702, 4.26335371223099123) within 1e-12
check derivative(quadratic, 1/3, 3/5, du = 0, dv = 1) ~= (0, 6.86997924961540734, -0.66483670157568458) within 1e-12
