// The NURBS Book: Generalised translational sweep ((10.17)-(10.19))
geo 1
curve profile = nurbs([(0, 0, -1), (0, 1, 0), (0, 0, 1)], weights = [1, 2, 1], degree = 2, knots = [0, 0, 0, 1, 1, 1])
curve path = nurbs([(0, 0, 0), (2, 0, 0), (3, 3, 1), (5, 3, 0)], weights = [1, 1, 3, 1], degree = 2, knots = [0, 0, 0, 1/2, 1, 1, 1])
surface s = sweep(profile, path, frame = "translate")
check s.points ~= [
  [(0, 0, -1), (2, 0, -1), (3, 3, 0), (5, 3, -1)],
  [(0, 1, 0), (2, 1, 0), (3, 4, 1), (5, 4, 0)],
  [(0, 0, 1), (2, 0, 1), (3, 3, 2), (5, 3, 1)],
] within 5e-11
check s.weights ~= [[1, 1, 3, 1], [2, 2, 6, 2], [1, 1, 3, 1]] within 6e-11
check s(1/3, 1/4) ~= (19/10, 197/130, 9/130) within 1.9e-11
check s(0, 1/2) ~= (11/4, 9/4, -1/4) within 2.75e-11
check s(0.9, 0.9) ~= (15/4, 5401/1652, 2123/1652) within 3.75e-11
