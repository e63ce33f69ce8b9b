// Vukašinović, Duhovnik: Cone R=3 H=4 ((1.3))
geo 1
let radius = 3
let height = 4
surface s = parametric((a, b) => (radius*(1 - b/height)*cos(a), radius*(1 - b/height)*sin(a), b), 0..2*pi, 0..height)
surface exact = cone((0, 0, 0), radius, 0, height)
check s(pi/3, 1) ~= (1.125, 1.948557158514987, 1) within 1.95e-12
check closest(exact, (1.125, 1.948557158514987, 1)).distance < 1e-9
check s(0, 0) ~= (3, 0, 0) within 3e-12
check closest(exact, (3, 0, 0)).distance < 1e-9
check s(pi/2, 4) ~= (0, 0, 4) within 4e-12
check closest(exact, (0, 0, 4)).distance < 1e-9
check gaussian(s, pi/3, 1) ~= 0 within 1e-12
check mean(s, pi/3, 1) ~= -0.17777777777777778 within 1e-11
check normal(s, pi/3, 1) ~= (0.4, 0.69282032302755092, 0.6) within 1e-11
check classify(s, pi/2, 4) == "singular"
