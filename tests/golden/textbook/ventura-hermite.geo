// Ventura: Cubic segment from end points and tangents, Hermite matrix (p.5-6 [H])
geo 1
curve c = hermite([(0, 0, 0), (3, 1, 2)], [(1, 4, 0), (2, -1, 3)])
curve power_form = polynomial([(0, 0, 0), (1, 4, 0), (5, -4, 3), (-3, 1, -1)])
check [for t in linspace(0, 1, 6): c(t).x] ~= [for t in linspace(0, 1, 6): power_form(t).x] within 5e-12
check [for t in linspace(0, 1, 6): c(t).y] ~= [for t in linspace(0, 1, 6): power_form(t).y] within 4e-12
check [for t in linspace(0, 1, 6): c(t).z] ~= [for t in linspace(0, 1, 6): power_form(t).z] within 3e-12
check c(0) ~= (0, 0, 0) within 1e-12
check derivative(c, 0) ~= (1, 4, 0) within 4e-12
check c(1/4) ~= (33/64, 49/64, 11/64) within 1e-12
check derivative(c, 1/4) ~= (47/16, 35/16, 21/16) within 2.94e-12
check c(1/2) ~= (11/8, 9/8, 5/8) within 1.37e-12
check derivative(c, 1/2) ~= (15/4, 3/4, 9/4) within 3.75e-12
check c(1) ~= (3, 1, 2) within 3e-12
check derivative(c, 1) ~= (2, -1, 3) within 3e-12
