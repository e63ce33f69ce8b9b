// The NURBS Book: Swung surface with alpha=1 and the unit 9-point circle = surface of revolution (Sec 10.2 last sentence)
geo 1
curve profile = bspline([(1, 0, 0), (2, 0, 1), (1, 0, 3)], degree = 2, knots = [0, 0, 0, 1, 1, 1])
curve trajectory = circle((0, 0), 1)
surface s = swung(profile, trajectory)
check s(1/3, 1/8) ~= (1.021376461713902, 1.021376461713902, 0.77777777777777778) within 1.02e-12
check hypot(s(1/3, 1/8).x, s(1/3, 1/8).y) ~= 13/9 within 1.44e-12
check s(1/2, 1/4) ~= (0, 1.5, 1.25) within 1.5e-12
check hypot(s(1/2, 1/4).x, s(1/2, 1/4).y) ~= 3/2 within 1.5e-12
check s(0.7, 0.9) ~= (1.1556329711925266, -0.82517418518318483, 1.89) within 1.89e-12
check hypot(s(0.7, 0.9).x, s(0.7, 0.9).y) ~= 71/50 within 1.42e-12
