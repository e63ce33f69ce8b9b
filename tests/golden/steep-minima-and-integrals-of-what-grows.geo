unit mm
// Least values beside which a function is steep and bounded.
check minimize(u => -1/(1e-6 + u.x^2), start = {x: 3}).x ~= 0 within 1e-9
check minimize(u => -1/(u.x^2 + u.y^2 + 1e-4), start = {x: 3, y: 1}, report = true).value ~= -1e4 within 1e-6
check minimize(u => -exp(-1e4*u.x^2), start = {x: 0.03}).x ~= 0 within 1e-6
check minimize(u => sqrt(abs(u.x - 1)), start = {x: 3}).x ~= 1 within 1e-9
check minimize(u => abs(u.x - 1), start = {x: 3}).x ~= 1 within 1e-9
check minimize(u => max(u.x, -2*u.x), start = {x: 3}).x ~= 0 within 1e-9
check minimize(u => -sqrt(u.x), start = {x: 0.5}, within = {x: 0..1}).x ~= 1
check minimize(u => sqrt(u.x), start = {x: 0.5}, within = {x: 0..1}).x ~= 0
check minimize(u => -1/u.x, start = {x: 1}, within = {x: 0.001..5}).x ~= 0.001
check minimize(u => u.x*ln(u.x), start = {x: 3}).x ~= exp(-1) within 1e-6
check minimize(x => ln(x), within = 1e-9..5) ~= 1e-9 within 1e-15

// Integrals up to places without bound, within a tolerance.
check integrate(x => 1/sqrt(x), 0..1, tolerance = 1e-6) ~= 2 within 1e-6
check integrate(x => ln(x), 0..1, tolerance = 0.01) ~= -1 within 0.01
check integrate(x => 1/x^0.9, 0..1, tolerance = 3) ~= 10 within 3
check integrate(x => 1/x^0.9, 0..1, tolerance = 0.1) ~= 10 within 0.1
check integrate(x => 1/abs(x - 0.3)^0.8, 0..1, tolerance = 0.1) ~= 5*(0.3^0.2 + 0.7^0.2) within 0.1
check integrate(x => 1/sqrt(1 - x^2), -1..1, tolerance = 0.1) ~= pi within 0.1
check integrate(p => ln(norm(p)), region(circle((0, 0), 1)), tolerance = 0.01) / 1mm^2 ~= -pi/2 within 0.01

// Roots between bounds: of two the one inside, one on a border, the least squares on one.
let circle_and_line = u => [u.x^2 + u.y^2 - 25, u.x - u.y - 1]
check solve(circle_and_line, start = {x: -0.1, y: -1}, within = {x: -9..0}).x ~= -3
check solve(circle_and_line, start = {x: 1, y: -1}, within = {x: 0..9}).x ~= 4
check solve(p => [p.x - 1, p.x*p.y - 2], start = (0.2, 0.3), within = [0..1, 0..2]) ~= (1, 2)
check solve(x => [x - 1, x - 2, x - 6], start = 0, within = 0..2.5) ~= 2.5
check solve(x => x^2 - 4, start = 1, within = 0..9) ~= 2

// As few digits as the document's unit has.
check "{12.3456mm:cm}" == "1.23456cm"
check "{0.1mm:cm} {25.4mm:in} {7.3mm:m}" == "0.01cm 1in 0.0073m"
