// Vukašinović, Duhovnik: Cylinder R=2 H=5 (s in degrees in the text; radians here) ((1.2))
geo 1
let radius = 2
let height = 5
surface s = parametric((a, b) => (radius*cos(a), radius*sin(a), b), 0..2*pi, 0..height)
surface exact = cylinder((0, 0, 0), radius, height)
check s(pi/3, 1.25) ~= (1, 1.7320508075688773, 1.25) within 1.73e-12
check closest(exact, (1, 1.7320508075688773, 1.25)).distance < 1e-9
check gaussian(s, pi/3, 1.25) ~= 0 within 1e-12
check mean(s, pi/3, 1.25) ~= -1/4 within 1e-12
check classify(s, pi/3, 1.25) == "parabolic"
check s(0, 0) ~= (2, 0, 0) within 2e-12
check closest(exact, (2, 0, 0)).distance < 1e-9
check gaussian(s, 0, 0) ~= 0 within 1e-12
check mean(s, 0, 0) ~= -1/4 within 1e-12
check classify(s, 0, 0) == "parabolic"
check s(3*pi/2, 5) ~= (0, -2, 5) within 5e-12
check closest(exact, (0, -2, 5)).distance < 1e-9
check gaussian(s, 3*pi/2, 5) ~= 0 within 1e-12
check mean(s, 3*pi/2, 5) ~= -1/4 within 1e-12
check classify(s, 3*pi/2, 5) == "parabolic"
