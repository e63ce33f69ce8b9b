// Ventura: Circular arc from an isosceles triangle (p.16)
geo 1
curve c0 = conic((0, 0), (1/2, 0.5), (1, 0), 1/sqrt(1 + 4*0.5^2))
check radius_of_curvature(c0, 1/3) ~= 0.70710678118654752 within 1e-12
check c0.weights[1]/c0.weights[0] ~= 0.70710678118654752 within 1e-12
check c0.weights[0]/c0.weights[1] ~= 1.414213562373095 within 1.41e-12
check c0(1/3) ~= (0.3083906286540756, 0.18065104775679266, 0) within 1e-12
check center_of_curvature(c0, 1/3) ~= (0.5, -0.5, 0) within 1e-12
curve c1 = conic((0, 0), (1/2, 0.375), (1, 0), 1/sqrt(1 + 4*0.375^2))
check radius_of_curvature(c1, 1/3) ~= 5/6 within 1e-12
check c1.weights[1]/c1.weights[0] ~= 4/5 within 1e-12
check c1.weights[0]/c1.weights[1] ~= 5/4 within 1.25e-12
check c1(1/3) ~= (13/41, 6/41, 0) within 1e-12
check center_of_curvature(c1, 1/3) ~= (1/2, -2/3, 0) within 1e-12
curve c2 = conic((0, 0), (1/2, 1), (1, 0), 1/sqrt(1 + 4*1^2))
check radius_of_curvature(c2, 1/3) ~= 0.55901699437494742 within 1e-12
check c2.weights[1]/c2.weights[0] ~= 0.44721359549995794 within 1e-12
check c2.weights[0]/c2.weights[1] ~= 2.2360679774997897 within 2.24e-12
check c2(1/3) ~= (0.2790496134403554, 0.26349871146785132, 0) within 1e-12
check center_of_curvature(c2, 1/3) ~= (0.5, -0.25, 0) within 1e-12
curve c3 = conic((0, 0), (1/2, 0.1), (1, 0), 1/sqrt(1 + 4*0.1^2))
check radius_of_curvature(c3, 1/3) ~= 2.5495097567963924 within 2.55e-12
check c3.weights[1]/c3.weights[0] ~= 0.98058067569092016 within 1e-12
check c3.weights[0]/c3.weights[1] ~= 1.019803902718557 within 1.02e-12
check c3(1/3) ~= (0.33188234163113418, 0.043960780543711393, 0) within 1e-12
check center_of_curvature(c3, 1/3) ~= (0.5, -2.5, 0) within 2.5e-12
