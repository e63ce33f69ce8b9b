// Vukašinović, Duhovnik: Two quarter arcs with quadratic parameters ((1.62), Fig 1.33 (corrected second derivatives))
geo 1
curve f = parametric(u => (-cos(u^2*pi/2), sin(u^2*pi/2), 0), 0..1)
curve g = parametric(v => (sin(v^2*pi/2), cos(v^2*pi/2), 0), 0..1)
curve f_unit = parametric(p => (-cos(p*pi/2), sin(p*pi/2)), 0..1)
curve g_unit = parametric(q => (sin(q*pi/2), cos(q*pi/2)), 0..1)
check derivative(f, 1/2) ~= (0.60111772988434627, 1.4512265760697155, 0) within 1.45e-12
check derivative(f, 1/2, order = 2) ~= (3.4818168348061363, 1.958219630065813, 0) within 3.48e-12
check curvature(f, 1/2) ~= 1 within 1e-12
check derivative(f, 1) ~= (3.1415926535897932, 0, 0) within 3.14e-12
check derivative(f, 1, order = 2) ~= (3.1415926535897932, -9.8696044010893586, 0) within 9.87e-12
check curvature(f, 1) ~= 1 within 1e-12
check derivative(g, 0) ~= (0, 0, 0) within 1e-12
check derivative(g, 0, order = 2) ~= (3.1415926535897932, 0, 0) within 3.14e-12
check curvature(g, 1/2) ~= 1 within 1e-12
check derivative(f_unit, 1) ~= (1.5707963267948966, 0, 0) within 1.57e-12
check derivative(f_unit, 1, order = 2) ~= (0, -2.4674011002723397, 0) within 2.47e-12
check continuity(f_unit, g_unit).c >= 2
check continuity(f_unit, g_unit).g >= 2
