// The size of a number that starts beside zero is not that of its unknown.
fn bowl(u) = (u.a - 3)^2 + (u.b - 2)^2
fn far(u) = (u.a - 1e6)^2 + (u.b - 2)^2
fn valley(u) = 100 * (u.b - u.a^2)^2 + (1 - u.a)^2

let starts = [{a: 1e-9, b: 1}, {a: 1e-12, b: 1e-12}, {a: -1e-200, b: 1}]
check every(starts, f = s => minimize(bowl, start = s) ~= {a: 3, b: 2})
check every(starts, f = s => minimize(far, start = s) ~= {a: 1e6, b: 2})
check minimize(valley, start = {a: 1e-8, b: 1e-8}) ~= {a: 1, b: 1}

// What lies many times the start away is not without bound.
check minimize(u => (u.a - 1e9)^2, start = {a: 1}).a ~= 1e9
check minimize(u => cosh(u.a - 3), start = {a: 1e-9}).a ~= 3
check minimize(u => u.a^2 + u.b^2, start = {a: 1e-9, b: 1e-9}, subject = u => u.a + u.b >= 4) ~= {a: 2, b: 2}
check minimize(u => u.a + u.b, start = {a: 1e-9, b: 1e-9}, subject = u => u.a^2 + u.b^2 <= 1) ~= {a: -sqrt(0.5), b: -sqrt(0.5)}

// What is small by itself stays so.
check minimize(u => (u.a - 2e-6)^2, start = {a: 1e-6}).a ~= 2e-6 within 1e-15
