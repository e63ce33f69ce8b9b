curve c = clamped((1, 1), (3, 1), (5, 7), (7, 1), (9, 4))
check greville(c) ~= [0, 1/3, 1, 5/3, 2] within 1e-15
check edit_points(c) == [for t in greville(c): c(t)]
check knot_points(c) == [c(0), c(1), c(2)]
check control_polygon(c).points == c.points
check sum(basis(c, 0.7)) ~= 1 within 1e-15
check sum([for i in 0..4: basis(c, 0.7)[i]*c.points[i]]) ~= c(0.7) within 1e-14
check basis(c, 1) ~= [0, 0.25, 0.5, 0.25, 0] within 1e-15
curve w = nurbs((1, 0), (1, 1), (0, 1), weights = [1, 1, 2], degree = 2)
check sum([for i in 0..2: basis(w, 0.2)[i]*w.points[i]]) ~= w(0.2) within 1e-15
check de_casteljau(w, 0.5)[2][0] ~= (0.6, 0.8) within 1e-15
check len(control_polygon(nurbs((0, 0), (9, 9), (2, 0), (3, 3), weights = [1, 0, 1, 1])).points) == 3
check [for one in compatible([line((0, 0), (3, 0)), circle((0, 0), 1)]): one.degree] == [2, 2]
