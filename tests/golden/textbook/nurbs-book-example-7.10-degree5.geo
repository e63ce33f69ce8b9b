// The NURBS Book: Full circle as one degree-5 rational Bezier with positive weights (Sec 10.3 (Example E7.10))
geo 1
curve c = bezier([(0, -1), (4, -1), (2, 3), (-2, 3), (-4, -1), (0, -1)], weights = [1, 1/5, 1/5, 1/5, 1/5, 1])
check c(0) ~= (0, -1, 0) within 1e-12
check norm(c(0)) ~= 1 within 1e-12
check c(1/7) ~= (840/1369, -1081/1369, 0) within 1e-12
check norm(c(1/7)) ~= 1 within 1e-12
check c(1/4) ~= (24/25, -7/25, 0) within 1e-12
check norm(c(1/4)) ~= 1 within 1e-12
check c(1/2) ~= (0, 1, 0) within 1e-12
check norm(c(1/2)) ~= 1 within 1e-12
check c(2/3) ~= (-24/25, 7/25, 0) within 1e-12
check norm(c(2/3)) ~= 1 within 1e-12
check c(0.9) ~= (-720/1681, -1519/1681, 0) within 1e-12
check norm(c(0.9)) ~= 1 within 1e-12
check continuity(c, c).c == 1
check continuity(c, c).g >= 2
