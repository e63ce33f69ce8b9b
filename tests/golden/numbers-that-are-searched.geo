unit mm
// A bottle that holds three quarters of a litre.
fn bottle(h) = revolve(polyline((30, 0, 0), (40, 0, 0.3 * h), (38, 0, 0.7 * h), (12, 0, h)), axis = (0, 0, 1))
fn holds(h) = volume([bottle(h), disc(plane((0, 0, 0), (0, 0, -1)), 30), disc(plane((0, 0, h), (0, 0, 1)), 12)])
let h = solve(h => holds(h) - 750_000, within = 10cm..40cm)
check holds(h) ~= 750_000 within 1e-6
let told = solve(h => holds(h) - 750_000, within = 10cm..40cm, report = true)
check told.root == h and told.evaluations < 20 and abs(told.residual) < 1e-6
print "height {h:.2mm}"

// Roots to the last digit, of either order, at ends, by themselves.
check solve(x => x^3 - 2, within = 0..2) ~= cbrt(2) within 1e-15
check solve(x => exp(x) - 1e6, within = 0..20) ~= ln(1e6) within 1e-14
check solve(x => x, within = 0..1) == 0 and solve(x => x - 1, within = 0..1) == 1
check solve(x => (x - 0.7)^2, within = 0..2) ~= 0.7 within 1e-6
check solve(a => sin(a) - 0.5, within = 0deg..90deg) ~= 30deg within 1e-14
check solve(x => (x - 1)*(x - 1.01)*(x - 1.7), within = 0..2, all = true) ~= [1, 1.01, 1.7] within 1e-13
check solve(x => x^2 + 1, within = -1..1, all = true) == []
check len(solve(x => sin(50*x), within = 0.01..3, all = true)) == 47

// Least and greatest values, inside and at ends.
check minimize(x => x^2 - x, within = 0..5) ~= 0.5 within 1e-6
check minimize(x => x, within = 2..5) == 2 and maximize(x => x, within = 2..5) == 5
let nearest = minimize(t => norm(circle((0, 0), 1)(t) - (3, 4)), within = 0..1)
check nearest ~= closest(circle((0, 0), 1), (3, 4)).t within 1e-7
check maximize(r => r * (10mm - r), within = 0mm..10mm) ~= 5mm within 1e-6
// What they find goes on into geometry.
curve at_best = circle((0, 0), maximize(r => r * (10 - r), within = 0..10))
check at_best.start.x ~= 5 within 1e-6

// Integrals.
check integrate(x => x^7, 0..2) ~= 32 within 1e-12
check integrate(x => 1/sqrt(x), 0..1) ~= 2 within 1e-11
check integrate(t => abs(t - 0.3), 0..1) ~= 0.29 within 1e-13
check integrate(t => exp(-t^2), -8..8) ~= sqrt(pi) within 1e-13
curve c = bezier((0, 0), (1, 3), (3, -2), (4, 1))
check integrate(t => norm(derivative(c, t)), 0..1) ~= length(c) within 1e-12
check integrate(t => derivative(c, t), 0..1) ~= c.end - c.start
check integrate(x => x, 0mm..4mm) ~= 2mm * 4mm within 1e-12
// A double integral, and one of what is solved.
check integrate(x => integrate(y => x*y^2, 0..x), 0..1) ~= 1/15 within 1e-14
check integrate(a => solve(x => x^3 - a, within = 0..2), 0..1) ~= 0.75 within 1e-9
check integrate(x => sin(1/x), 0.01..1, tolerance = 1e-6) ~= 0.50398 within 1e-4

// Several unknowns: points, lists and records; of more equations than unknowns the squares are least.
let p = solve(p => [norm(p) - 5, p.y - 2*p.x], start = (1, 1))
check p ~= (sqrt(5), 2*sqrt(5)) within 1e-12
let sizes = solve(u => [u.beam * u.draft - 6m * 1m, u.beam / u.draft - 3], start = {beam: 3m, draft: 1m})
check sizes.beam ~= 3 * sizes.draft and sizes.beam * sizes.draft ~= 6m * 1m
check solve(x => [10*(x[1] - x[0]^2), 1 - x[0]], start = [-1.2, 1]) ~= [1, 1] within 1e-9
check solve(x => x^3 - 2, start = 1) ~= cbrt(2) within 1e-12
let line_fit = solve(k => [for q in [(0, 1), (1, 3), (2, 4), (3, 8)]: k[0] + k[1]*q.x - q.y], start = [0, 0])
check line_fit ~= [0.7, 2.2] within 1e-7
// The circle through three points, and where three surfaces meet.
let through = solve(c => [for q in [(1, 0), (0, 1), (-1, 0.2)]: norm(q - (c.x, c.y)) - c.r], start = {x: 0.1, y: 0.1, r: 1})
check [for q in [(1, 0), (0, 1), (-1, 0.2)]: norm(q - (through.x, through.y))] ~= [through.r, through.r, through.r] within 1e-12
check solve(x => x - 1, start = 5, report = true).residual == 0
