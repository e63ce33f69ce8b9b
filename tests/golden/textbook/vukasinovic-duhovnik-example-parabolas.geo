// Vukašinović, Duhovnik: Two parabolas: C1, not C2, G2 (Example in 1.5.3, Fig 1.35)
geo 1
curve f = polynomial([(-1, 0, 0), (0, 2, 0), (1, -1, 0)])
curve g = polynomial([(0, 1, 0), (2, 0, 0), (-1, -1, 0)])
check f(0) ~= (-1, 0, 0) within 1e-12
check derivative(f, 0) ~= (0, 2, 0) within 2e-12
check curvature(f, 0) ~= 1/2 within 1e-12
check g(0) ~= (0, 1, 0) within 1e-12
check derivative(g, 0) ~= (2, 0, 0) within 2e-12
check curvature(g, 0) ~= 1/2 within 1e-12
check f(1/2) ~= (-3/4, 3/4, 0) within 1e-12
check derivative(f, 1/2) ~= (1, 1, 0) within 1e-12
check curvature(f, 1/2) ~= 1.414213562373095 within 1.41e-12
check g(1/2) ~= (3/4, 3/4, 0) within 1e-12
check derivative(g, 1/2) ~= (1, -1, 0) within 1e-12
check curvature(g, 1/2) ~= 1.414213562373095 within 1.41e-12
check f(1) ~= (0, 1, 0) within 1e-12
check derivative(f, 1) ~= (2, 0, 0) within 2e-12
check curvature(f, 1) ~= 1/2 within 1e-12
check g(1) ~= (1, 0, 0) within 1e-12
check derivative(g, 1) ~= (0, -2, 0) within 2e-12
check curvature(g, 1) ~= 1/2 within 1e-12
check derivative(f, 1, order = 2) ~= (2, -2, 0) within 2e-12
check derivative(g, 0, order = 2) ~= (-2, -2, 0) within 2e-12
check cross(derivative(f, 1), derivative(f, 1, order = 2)) ~= (0, 0, -4) within 4e-12
check derivative(f, 1, order = 2) - derivative(g, 0, order = 2) ~= (4, 0, 0) within 4e-12
check continuity(f, g).c == 1
check continuity(f, g).g >= 2
