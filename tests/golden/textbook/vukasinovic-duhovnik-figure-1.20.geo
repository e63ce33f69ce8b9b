// Vukašinović, Duhovnik: Conics by one weight: quadratic P=(0,0),(1,1),(2,0) (Fig 1.20)
geo 1
curve c0 = conic((0, 0), (1, 1), (2, 0), 1/2)
check conic_kind(c0) == "ellipse"
check c0(1/4) ~= (5/13, 3/13, 0) within 1e-12
check c0(1/2) ~= (1, 1/3, 0) within 1e-12
curve c1 = conic((0, 0), (1, 1), (2, 0), sqrt(2)/2)
check conic_kind(c1) == "ellipse"
check c1(1/4) ~= (0.43830640849944245, 0.29788301062430307, 0) within 1e-12
check c1(1/2) ~= (1, 0.41421356237309505, 0) within 1e-12
curve c2 = conic((0, 0), (1, 1), (2, 0), 1)
check conic_kind(c2) == "parabola"
check c2(1/4) ~= (1/2, 3/8, 0) within 1e-12
check c2(1/2) ~= (1, 1/2, 0) within 1e-12
curve c3 = conic((0, 0), (1, 1), (2, 0), 2)
check conic_kind(c3) == "hyperbola"
check c3(1/4) ~= (7/11, 6/11, 0) within 1e-12
check c3(1/2) ~= (1, 2/3, 0) within 1e-12
check radius_of_curvature(c1, 1/3) ~= 1.414213562373095 within 1.41e-12
