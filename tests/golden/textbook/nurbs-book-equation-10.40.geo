// The NURBS Book: Bicubically blended Coons patch (twist-compatible data) ((10.37)-(10.43), A10.4)
geo 1
curve c0 = bezier((0, 0, 3), (2.25, 0, 3.75), (4.5, 0, 6), (6.75, 0, 2.5), (9, 0, -2))
curve c1 = bezier((0, 9, 3), (3, 9, -2), (6, 9, 5), (9, 9, 0))
curve d0 = bezier((0, 0, 3), (0, 3, 4), (0, 6, 3), (0, 9, 3))
curve d1 = bezier((9, 0, -2), (9, 3, -3), (9, 6, 3), (9, 9, 0))
curve cross_c0 = bezier((0, 9, 3), (0, 9, 3), (0, 9, -3), (0, 9, -3))
curve cross_c1 = bezier((0, 9, 0), (0, 9, -3), (0, 9, -3), (0, 9, -9))
curve cross_d0 = bezier((9, 0, 3), (9, 0, 3), (9, 0, -12), (9, 0, -15))
curve cross_d1 = bezier((9, 0, -18), (9, 0, -18), (9, 0, -9), (9, 0, -15))
surface s = coons_bicubic(u = [c0, c1], v = [d0, d1], cross_u = [cross_c0, cross_c1], cross_v = [cross_d0, cross_d1])
check [s.degree_u, s.degree_v] == [4, 3]
check s.points ~= [
  [(0, 0, 3), (0, 3, 4), (0, 6, 3), (0, 9, 3)],
  [(9/4, 0, 15/4), (9/4, 3, 19/4), (9/4, 6, 0), (9/4, 9, -3/4)],
  [(9/2, 0, 6), (9/2, 3, 6), (9/2, 6, 5/2), (9/2, 9, 3/2)],
  [(27/4, 0, 5/2), (27/4, 3, 3/2), (27/4, 6, 21/4), (27/4, 9, 15/4)],
  [(9, 0, -2), (9, 3, -3), (9, 6, 3), (9, 9, 0)],
] within 9e-12
check twist(s, 0, 0) ~= (0, 0, 0) within 1.8e-11
check twist(s, 0, 1) ~= (0, 0, -9) within 1.8e-11
check twist(s, 1, 0) ~= (0, 0, 0) within 1.8e-11
check twist(s, 1, 1) ~= (0, 0, -18) within 1.8e-11
check derivative(s, 1/3, 0, du = 0, dv = 1) ~= (0, 9, 13/9) within 9e-12
check derivative(s, 0, 1/3) ~= (9, 0, -1) within 9e-12
check derivative(s, 0.8, 0, du = 0, dv = 1) ~= (0, 9, -297/125) within 9e-12
check derivative(s, 0, 0.8) ~= (9, 0, -1497/125) within 1.2e-11
check s(1/2, 1/2) ~= (9/2, 9/2, 199/64) within 4.5e-12
check s(1/3, 3/4) ~= (3, 27/4, 851/432) within 6.75e-12
