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

// The best of several unknowns: a valley, bounds, equations and inequalities; Hock & Schittkowski, no. 71.
check minimize(x => 100*(x[1] - x[0]^2)^2 + (1 - x[0])^2, start = [-1.2, 1]) ~= [1, 1] within 1e-8
let tin = minimize(u => 2*pi*u.r^2 + 2*pi*u.r*u.h, start = {r: 5cm, h: 5cm}, subject = u => pi*u.r^2*u.h == 1e6, report = true)
check tin.at.h ~= 2*tin.at.r within 1e-4 and tin.derivatives == "exact"
let hs = minimize(x => x[0]*x[3]*(x[0] + x[1] + x[2]) + x[2], start = [1, 5, 5, 1], within = 1..5,
  subject = x => sum([for a in x: a^2]) == 40 and x[0]*x[1]*x[2]*x[3] >= 25)
check hs ~= [1, 4.74299963, 3.82114998, 1.37940829] within 1e-6
check minimize(p => norm(p - (3, 4)), start = (0.1, 0), within = [0..1, 0..1]) ~= (1, 1) within 1e-8
check minimize(u => (u.a - 2)^2 + (u.b + 1)^2, within = {a: 0..1, b: 0..1}) ~= {a: 1, b: 0} within 1e-8
check maximize(u => u.a * u.b, start = {a: 1, b: 1}, within = {b: 0..1}, subject = [u => u.a <= 7, u => u.b >= 0]) ~= {a: 7, b: 1} within 1e-8
// Conditions behind definitions, in lists and branches; a start on a saddle; places without a value.
check minimize(p => p.x + p.y, start = (2, 1), subject = p => { let r = norm(p)
  [r <= 1, if r > 0 then p.x >= -5 else p.y >= -5] }) ~= (-sqrt(0.5), -sqrt(0.5)) within 1e-6
check abs(minimize(u => u.x^4 - u.x^2 + u.y^2, start = {x: 0, y: 0}).x) ~= sqrt(0.5) within 1e-6
check minimize(u => u.x - ln(u.x), start = {x: 8}).x ~= 1 within 1e-6
// Through geometry that grows evenly the gradients are exact, elsewhere differences.
fn side(u) = area(revolve(polyline((u.r, 0, 0), (u.r, 0, u.h)), axis = (0, 0, 1)))
let cheapest = minimize(u => side(u) + 2*pi*u.r^2, start = {r: 5, h: 6}, subject = u => pi*u.r^2*u.h ~= 1000, report = true)
check cheapest.at.h ~= 2*cheapest.at.r within 1e-4 and cheapest.derivatives == "exact"
let straight = minimize(u => length(offset(line((0, 0), (3, u.h)), 1)), start = {h: 1}, report = true)
check straight.at.h ~= 0 within 1e-4 and straight.derivatives == "differences"

// Gradients: of fifty unknowns, through a curve, and by numbers with units.
let fifty = gradient(x => sum([for i in 0..<50: (i + 1) * x[i]^2]), [for i in 0..<50: i])
check fifty ~= [for i in 0..<50: 2 * (i + 1) * i]
check gradient(t => c(t).y, 0.25) ~= derivative(c, 0.25).y
check gradient(u => u.w * sin(u.a), {w: 2mm, a: 30deg}).w ~= 0.5

// Roots that are proven: near one another, all over a range, and none.
let waves = solve(x => sin(x), within = 1..100, all = true, report = true)
check len(waves) == 31 and every([for root in waves: root.proven])
check solve(x => (x - 0.3)*(x - 0.300001), within = 0..1, all = true) ~= [0.3, 0.300001] within 1e-12
check solve(x => (x - 0.7)^2, within = 0..2, report = true).proven == false
check solve(x => exp(x) + sqrt(x), within = 0.1..9, all = true) == []
// Derivatives of roots and of integrals; curves of them.
check gradient(a => solve(x => x^2 - a, within = 0..5), 4) ~= 0.25 within 1e-12
check gradient(a => integrate(x => a^2 * x, 0..2), 3) ~= 12 within 1e-12
curve rooted = parametric(t => (t, solve(x => x^3 + x - t, within = -1..2)), 0..1)
check derivative(rooted, 0.5).y ~= 1/(3*rooted(0.5).y^2 + 1) within 1e-9
check derivative(rooted, 0.5, order = 2).y ~= -6*rooted(0.5).y/(3*rooted(0.5).y^2 + 1)^3 within 1e-9
curve added = parametric(t => (t, integrate(x => sin(t*x), 0..1)), 0.5..2)
check derivative(added, 1).y ~= integrate(x => x*cos(x), 0..1) within 1e-10
// Integrals over boxes, curves and surfaces.
check integrate((x, y) => x * y^2, [0..1, 0..3]) ~= 4.5 within 1e-12
check integrate((x, y, z) => x + y + z, [0mm..1mm, 0mm..1mm, 0mm..2mm]) ~= 4 within 1e-12
check integrate(p => p.y^2, circle((0, 0), 2)) ~= 8*pi within 1e-10
check integrate(p => p, line((0, 0), (2, 4))) ~= (1, 2) * sqrt(20) within 1e-10
check integrate(p => p.z^2, [sphere((0, 0), 1), sphere((0, 0), 2)]) ~= 68*pi/3 within 1e-8

// Steps, kinks and what is large at one end alone are added up to the last digits, wherever they are.
check every([for j in random(60, seed = 3): integrate(x => if x < j then 1 else 0, 0..1) - j], f = off => abs(off) < 1e-12)
check integrate(x => if x < 0.123456789 then 1 else 0, 0..1) ~= 0.123456789 within 1e-13
check integrate(x => floor(x*10 + 0.3), 0..1) ~= 4.8 within 1e-12
check integrate(x => abs(x - 0.3), 0..1, report = true).evaluations < 500
check integrate(x => exp(-x), 0..1e6) ~= 1 and integrate(x => x^-2, 1..1e300) ~= 1
// Roots that bounds prove and one at the border; roots that are small beside the range.
check len(solve(x => sin(200*x), within = 0..10, all = true)) == 637
check solve(x => x - 1e-9, within = -1e9..1e9) == 1e-9 and solve(x => x - 1e-20, within = -1..3) == 1e-20
// A load on a fiftieth of the range is seen wherever it is.
check every([for j in random(40, seed = 5): integrate(x => if j*0.98 < x and x < j*0.98 + 0.02 then 5 else 0, 0..1)], f = sum => abs(sum - 0.1) < 1e-12)
