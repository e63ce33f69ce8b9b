// Ventura: Conic form factor k_c = w1 w3/(4 w2^2); 4k_c > 1 ellipse, = 1 parabola, < 1 hyperbola (printed inverted) (p.15)
geo 1
curve c0 = conic((0, 0), (1, 1), (2, 0), 1/2)
check c0.weights[0]*c0.weights[2]/c0.weights[1]^2 ~= 4 within 4e-12
check conic_kind(c0) == "ellipse"
curve c1 = conic((0, 0), (1, 1), (2, 0), 1)
check c1.weights[0]*c1.weights[2]/c1.weights[1]^2 ~= 1 within 1e-12
check conic_kind(c1) == "parabola"
curve c2 = conic((0, 0), (1, 1), (2, 0), 2)
check c2.weights[0]*c2.weights[2]/c2.weights[1]^2 ~= 1/4 within 1e-12
check conic_kind(c2) == "hyperbola"
curve c3 = conic((0, 0), (1, 1), (2, 0), sqrt(2)/2)
check c3.weights[0]*c3.weights[2]/c3.weights[1]^2 ~= 2 within 2e-12
check conic_kind(c3) == "ellipse"
curve c4 = bezier((0, 0), (1, 1), (2, 0), weights = [2, 1, 1/2])
check c4.weights[0]*c4.weights[2]/c4.weights[1]^2 ~= 1 within 1e-12
check conic_kind(c4) == "parabola"
curve c5 = bezier((0, 0), (1, 1), (2, 0), weights = [1, 3, 4])
check c5.weights[0]*c5.weights[2]/c5.weights[1]^2 ~= 4/9 within 1e-12
check conic_kind(c5) == "hyperbola"
