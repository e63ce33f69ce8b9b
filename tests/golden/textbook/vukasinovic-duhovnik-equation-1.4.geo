// Vukašinović, Duhovnik: Sphere R=5/2 ((1.4), z corrected to R sin t)
geo 1
let radius = 5/2
surface s = parametric((a, b) => (radius*cos(a)*cos(b), radius*sin(a)*cos(b), radius*sin(b)), 0..2*pi, -pi/2..pi/2)
surface exact = sphere((0, 0, 0), radius)
check s(0, 0) ~= (2.5, 0, 0) within 2.5e-12
check closest(exact, (2.5, 0, 0)).distance < 1e-9
check s(pi/3, pi/6) ~= (1.0825317547305483, 1.875, 1.25) within 1.87e-12
check closest(exact, (1.0825317547305483, 1.875, 1.25)).distance < 1e-9
check s(pi, -pi/4) ~= (-1.7677669529663688, 0, -1.7677669529663688) within 1.77e-12
check closest(exact, (-1.7677669529663688, 0, -1.7677669529663688)).distance < 1e-9
check s(0, pi/2) ~= (0, 0, 2.5) within 2.5e-12
check closest(exact, (0, 0, 2.5)).distance < 1e-9
check norm(s(1.1, 0.4)) ~= 5/2 within 2.5e-12
check gaussian(s, pi/3, pi/6) ~= 4/25 within 1e-12
check mean(s, pi/3, pi/6) ~= -2/5 within 1e-12
