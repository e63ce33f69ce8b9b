// An integral over no length is 0, one from the right to the left the negative.
check integrate(x => x^2, 2..2) == 0 and integrate(x => (x, 1), 1..1) == (0, 0)
check integrate(x => x^2, 3..0) ~= -9 within 1e-12
check integrate((x, y) => x * y^2, [1..0, 0..3]) ~= -4.5 within 1e-12
check integrate(x => 2cm, 3cm..1cm) ~= -4cm^2 within 1e-12

// By an end of the range the derivative is the function there: the fundamental theorem, to every order.
check gradient(b => integrate(x => x^2, 0..b), 3) ~= 9 within 1e-12
check gradient(a => integrate(x => x^2, a..5), 3) ~= -9 within 1e-12
check gradient(u => integrate(x => x * u.k, u.a..u.b), {a: 1, b: 2, k: 3}) ~= {a: -3, b: 6, k: 1.5} within 1e-12
check gradient(u => integrate((x, y) => x * y, [0..u.a, 0..u.b]), {a: 2, b: 3}) ~= {a: 9, b: 6} within 1e-10
curve sine = parametric(s => (s, integrate(cos, 0..s)), 0..3)
check every(linspace(0, 3, 7), s => sine(s).y ~= sin(s) within 1e-13)
check every(linspace(0, 3, 7), s => derivative(sine, s, order = 4).y ~= sin(s) within 1e-9)
// Leibniz: the function varies too.
curve both = parametric(t => (t, integrate(x => sin(t * x), 0..t^2)), 0.5..2)
check every([0.5, 1, 1.7], t => derivative(both, t).y ~= integrate(x => x * cos(t * x), 0..t^2) + 2 * t * sin(t^3) within 1e-9)

// A clothoid, as its definition has it: the curvature grows with the length.
let a = 60
curve clothoid = parametric(s => integrate(u => (cos(u^2 / (2 * a^2)), sin(u^2 / (2 * a^2))), 0..s), 0..90)
check length(clothoid) ~= 90 within 1e-9
check every([0, 30, 90], s => curvature(clothoid, s) ~= s / a^2 within 1e-12)
check clothoid.end ~= integrate(u => (cos(u^2 / (2 * a^2)), sin(u^2 / (2 * a^2))), 0..90) within 1e-12
check solve(b => integrate(x => x^2, 0..b) - 9, start = 1) ~= 3 within 1e-9

// Along curves and over surfaces that vary.
check gradient(r => integrate(p => p.y^2, line((0, 0), (r, 2 * r))), 2) ~= 4 * sqrt(5) * 4 within 1e-9
check gradient(h => integrate(p => p.z, extrude(line((0, 0), (3, 4)), (0, 0, h))), 2) ~= 10 within 1e-9
