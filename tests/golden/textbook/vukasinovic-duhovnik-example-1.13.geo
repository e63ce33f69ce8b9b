// Vukašinović, Duhovnik: Bezier cubic, 11 points (Example after (1.13), Fig 1.15)
geo 1
curve c = bezier((0, 0, 0), (1, 1, 0), (2, 0, 0), (3, 1, 0))
check c(0) ~= (0, 0, 0) within 1e-12
check c(0.1) ~= (3/10, 61/250, 0) within 1e-12
check c(0.2) ~= (3/5, 49/125, 0) within 1e-12
check c(0.3) ~= (9/10, 117/250, 0) within 1e-12
check c(0.4) ~= (6/5, 62/125, 0) within 1.2e-12
check c(0.5) ~= (3/2, 1/2, 0) within 1.5e-12
check c(0.6) ~= (9/5, 63/125, 0) within 1.8e-12
check c(0.7) ~= (21/10, 133/250, 0) within 2.1e-12
check c(0.8) ~= (12/5, 76/125, 0) within 2.4e-12
check c(0.9) ~= (27/10, 189/250, 0) within 2.7e-12
check c(1) ~= (3, 1, 0) within 3e-12
curve power_form = polynomial([(0, 0, 0), (3, 3, 0), (0, -6, 0), (0, 4, 0)])
check [for t in linspace(0, 1, 6): c(t).x] ~= [for t in linspace(0, 1, 6): power_form(t).x] within 3e-12
check [for t in linspace(0, 1, 6): c(t).y] ~= [for t in linspace(0, 1, 6): power_form(t).y] within 6e-12
check [for t in linspace(0, 1, 6): c(t).z] ~= [for t in linspace(0, 1, 6): power_form(t).z] within 1e-12
