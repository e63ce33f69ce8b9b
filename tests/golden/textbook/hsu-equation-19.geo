// Hsu: Hermite cubic: coefficients and 11 points ((12)-(22), Assignment 5; (18) corrected C2 = 3(P1-P0) - 2P0' - P1')
geo 1
curve c = hermite([(1, 0, 2), (4, 2, 0)], [(-1, 3, 1), (2, -2, 4)])
check c(0) ~= (1, 0, 2) within 1.2e-11
check derivative(c, 0, order = 1) ~= (-1, 3, 1) within 1.2e-11
check derivative(c, 0, order = 2)/2 ~= (9, 2, -12) within 1.2e-11
check derivative(c, 0, order = 3)/6 ~= (-5, -3, 9) within 1.2e-11
curve power_form = polynomial([(1, 0, 2), (-1, 3, 1), (9, 2, -12), (-5, -3, 9)])
check [for t in linspace(0, 1, 6): c(t).x] ~= [for t in linspace(0, 1, 6): power_form(t).x] within 9e-12
check [for t in linspace(0, 1, 6): c(t).y] ~= [for t in linspace(0, 1, 6): power_form(t).y] within 3e-12
check [for t in linspace(0, 1, 6): c(t).z] ~= [for t in linspace(0, 1, 6): power_form(t).z] within 1.2e-11
check c(0) ~= (1, 0, 2) within 2e-12
check c(0.1) ~= (197/200, 317/1000, 1989/1000) within 1.99e-12
check c(0.2) ~= (28/25, 82/125, 224/125) within 1.79e-12
check c(0.3) ~= (11/8, 999/1000, 1463/1000) within 1.46e-12
check c(0.4) ~= (43/25, 166/125, 132/125) within 1.72e-12
check c(0.5) ~= (17/8, 13/8, 5/8) within 2.12e-12
check c(0.6) ~= (64/25, 234/125, 28/125) within 2.56e-12
check c(0.7) ~= (599/200, 2051/1000, -93/1000) within 2.99e-12
check c(0.8) ~= (17/5, 268/125, -34/125) within 3.4e-12
check c(0.9) ~= (749/200, 2133/1000, -259/1000) within 3.74e-12
check c(1) ~= (4, 2, 0) within 4e-12
