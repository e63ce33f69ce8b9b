// Vukašinović, Duhovnik: Torus R=3 r=1 ((1.5), z corrected to r cos t)
geo 1
let major = 3
let minor = 1
surface s = parametric((a, b) => (cos(a)*(major + minor*sin(b)), sin(a)*(major + minor*sin(b)), minor*cos(b)), 0..2*pi, 0..2*pi)
surface exact = torus((0, 0, 0), major, minor)
check s(0, 0) ~= (3, 0, 1) within 3e-12
check closest(exact, (3, 0, 1)).distance < 1e-9
check s(pi/3, pi/6) ~= (1.75, 3.0310889132455353, 0.86602540378443865) within 3.03e-12
check closest(exact, (1.75, 3.0310889132455353, 0.86602540378443865)).distance < 1e-9
check s(pi, pi/2) ~= (-4, 0, 0) within 4e-12
check closest(exact, (-4, 0, 0)).distance < 1e-9
check s(pi/4, 3*pi/2) ~= (1.414213562373095, 1.414213562373095, 0) within 1.41e-12
check closest(exact, (1.414213562373095, 1.414213562373095, 0)).distance < 1e-9
check gaussian(s, 0, pi/2) ~= 1/4 within 1e-12
check gaussian(s, 0, 3*pi/2) ~= -1/2 within 1e-12
check gaussian(s, 0, 0) ~= 0 within 1e-12
