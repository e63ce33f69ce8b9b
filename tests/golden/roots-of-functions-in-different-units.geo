// Each equation counts, however small it is beside the others: one in billions, one in billionths.
fn functions(u) = [1e9 * (u.a + u.a^3 - 2 + 0.2*(u.b + 0.5)), 1e-9 * (exp(u.b) - exp(-0.5) + 0.1*(u.a - 1)), u.c + sin(u.c) - 2 - sin(2) + 0.3*(u.a - 1)*u.b]
let root = solve(functions, start = {a: 1.3, b: -0.2, c: 2.3})
check root.a ~= 1 within 1e-12 and root.b ~= -0.5 within 1e-12 and root.c ~= 2 within 1e-12
// A volume in cubic millimetres and an angle, for a cone.
let cone = solve(c => [pi/3 * c.r^2 * c.h - 2m^3, atan2(c.r, c.h) - 20deg], start = {r: 1m, h: 1m})
check cone.r ~= cbrt(2m^3 * 3/pi * tan(20deg)) within 1e-8 and cone.h ~= cone.r / tan(20deg) within 1e-8
// Derivatives pass through, by the theorem of implicit functions: of x + x^3 = 2q at 1 it is 2/4.
let slope = gradient(q => solve(u => [1e9 * (u[0] + u[0]^3 - 2*q), 1e-9 * (exp(u[1]) - exp(u[0]))], start = [1.5, 0.5])[1], 1)
check slope ~= 1/2 within 1e-6
