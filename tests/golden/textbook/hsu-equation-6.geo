// Hsu: Tangent vector and slopes ((4)-(6))
geo 1
curve c = parametric(u => (u^2+u, 2*u^3, 3*u), 0..1)
check derivative(c, 0.5) ~= (2, 3/2, 3) within 3e-12
check derivative(c, 0.5).y / derivative(c, 0.5).x ~= 3/4 within 1e-12
check derivative(c, 0.5).z / derivative(c, 0.5).y ~= 2 within 2e-12
check derivative(c, 0.5).x / derivative(c, 0.5).z ~= 2/3 within 1e-12
check derivative(c, 1) ~= (3, 6, 3) within 6e-12
check derivative(c, 1).y / derivative(c, 1).x ~= 2 within 2e-12
check derivative(c, 1).z / derivative(c, 1).y ~= 1/2 within 1e-12
check derivative(c, 1).x / derivative(c, 1).z ~= 1 within 1e-12
