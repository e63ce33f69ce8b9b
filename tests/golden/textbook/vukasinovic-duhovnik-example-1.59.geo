// Vukašinović, Duhovnik: Two collinear segments: not C1 with [0,1] parameters, C1 with unit-speed parameters, always G2 ((1.59)-(1.61), Fig 1.32)
geo 1
curve f = line((0, 0, 0), (1, 2, 2))
curve g = line((1, 2, 2), (3, 6, 6))
curve f_unit = reparametrize(f, 0..length(f))
curve g_unit = reparametrize(g, 0..length(g))
check derivative(f, 1) ~= (1, 2, 2) within 2e-12
check derivative(g, 0) ~= (2, 4, 4) within 4e-12
check continuity(f, g).c == 0
check continuity(f, g).g >= 2
check derivative(f_unit, 0) ~= (1/3, 2/3, 2/3) within 1e-12
check derivative(g_unit, 0) ~= (1/3, 2/3, 2/3) within 1e-12
check continuity(f_unit, g_unit).c >= 2
