// One unknown comes to its place by a power, a kink or a logarithm long before the other, from whichever side.
fn searched(f, start) = minimize(f, start = start, report = true)

let power = searched(u => u.a^4 + ln(1 + (u.b - 2)^2), {a: -41, b: 20})
check power.value < 1e-20 and power.evaluations < 500
let powers = searched(u => u.a^4 + u.b^6, {a: -4, b: 2})
check powers.value < 1e-30 and powers.evaluations < 400
let logarithm = searched(u => 1e-6*u.a^2 + ln(1 + u.b^2), {a: -0.1459, b: -0.9596})
check logarithm.value < 1e-20 and logarithm.evaluations < 200

// At the kink of `a` the slope of `b` is zero: 2*v/(1 + v^2) = 0.2*(5 - v) with v = b + 3.
let kink = searched(u => abs(u.a - 2) + ln(1 + (u.b + 3)^2) + 0.1*(u.a - u.b)^2, {a: -0.0299, b: 0.8208})
let v = kink.at.b + 3
check kink.at.a ~= 2 within 1e-6
check 2*v/(1 + v^2) ~= 0.2*(5 - v) within 1e-4
// At the kink of `b` that of `a` is: sinh((a - 1)/10)/10 + 0.2*(a + 3) = 0.
let hyperbolic = searched(u => cosh((u.a - 1)/10) + abs(u.b + 3) + 0.1*(u.a - u.b)^2, {a: -40.7956, b: -27.9845})
check hyperbolic.at.b ~= -3 within 1e-6
check sinh((hyperbolic.at.a - 1)/10)/10 + 0.2*(hyperbolic.at.a + 3) ~= 0 within 1e-6

// To the rounding that a function has of its own.
let noise = searched(u => (u.a - 1)^2 + (u.b - 2)^2 + 1e-10*sin(1e6rad*u.a), {a: 5, b: 7})
check noise.at ~= {a: 1, b: 2} within 1e-4
check noise.value ~= 0 within 1e-9

// Steep along one unknown, and from so far that the first step is far too long.
check searched(u => 1e12*(u.a - 3e-8)^2 + (u.b - 1)^2, {a: 0, b: 5}).at.a ~= 3e-8 within 1e-12
fn beale(u) = (1.5 - u.a + u.a*u.b)^2 + (2.25 - u.a + u.a*u.b^2)^2 + (2.625 - u.a + u.a*u.b^3)^2
let far = [{a: 1000, b: 1000}, {a: 1000, b: 1}, {a: 1e6, b: 1e6}]
check every(far, f = s => searched(beale, s).at ~= {a: 3, b: 0.5} within 1e-6)
fn singular(u) = (u.a + 10*u.b)^2 + 5*(u.c - u.d)^2 + (u.b - 2*u.c)^4 + 10*(u.a - u.d)^4
check searched(singular, {a: 3000, b: -1000, c: 0, d: 1000}).value < 1e-20
check searched(singular, {a: 3e6, b: -1e6, c: 0, d: 1e6}).value < 1e-10
