geo 1
unit mm
// Near a least value a function is above it by the square of the distance alone: values tell half of the digits of the place,
// slopes all of them.
fn is_exact(a, b) = abs(a - b) <= 4e-16 * abs(b)

// One number: smooth, by an angle, with a unit, at the tip of a kink, on a quartic floor.
check is_exact(maximize(x => sin(x * 1rad), within = 0..10), pi/2)
check is_exact(maximize(t => sin(t), within = 0deg..360deg), 90deg)
check minimize(r => (r - 3mm)^2, within = 1mm..1cm) == 3mm
check minimize(x => abs(x - 1), within = 0..3) == 1
check is_exact(minimize(x => max(x^2, 1 - x), within = 0..3), (sqrt(5) - 1) / 2)
check minimize(x => (x - 1)^4, within = -3..4) == 1
check is_exact(minimize(x => abs(x^2 - 2), within = 0..3), sqrt(2))
// At an end of the range, where slopes tell nothing more.
check minimize(x => exp(x), within = 2..3) == 2
check minimize(x => exp(x), within = 2..3, report = true).derivatives == "exact"
check minimize(x => length(offset(line((0, 0), (1, x)), 0.1)), within = -1..2, report = true).derivatives == "none"

// Several: free, under conditions, against a bound, with geometry.
let free = minimize(u => (u.x - 1)^2 + exp(u.y) - 2*u.y, start = {x: 0, y: 0})
check free.x == 1 and is_exact(free.y, ln(2))
let on = minimize(p => norm(p - (3, 4)), start = (0, 0), subject = p => norm(p) <= 1)
check norm(on - (0.6, 0.8)) < 1e-15
let corner = minimize(u => u.a + u.b, within = {a: 0..9, b: 1..9}, subject = u => u.a * u.b >= 9)
check abs(corner.a - 3) < 1e-14 and abs(corner.b - 3) < 1e-14
let held = minimize(u => (u.a - 2)^2 + (u.b - u.a)^2, within = {a: 0..1.5, b: -4..4}, start = {a: 1, b: 0})
check held.a == 1.5 and is_exact(held.b, 1.5)
let can = minimize(u => 2*pi*u.r*(u.r + u.h), start = {r: 40, h: 40}, within = {r: 10..80}, subject = u => pi*u.r^2*u.h >= 1e6)
check abs(can.h - 2*can.r) < 1e-11
// The point of an ellipse that is nearest to one beside it: a root of Lagrange's equations.
curve ellipse = conic((2, 0), (2, 1), (0, 1), sqrt(1/2))
let foot = minimize(t => norm(ellipse(t) - (2, 2)), within = 0..1)
check is_exact(foot, closest(ellipse, (2, 2)).t)

// More equations than unknowns.
check solve(u => [u.x - 1, u.x - 2, u.x - 6], start = {x: 0}).x == 3
let fit = solve(u => [u.a - 2, u.a*exp(u.b) - 3, u.a*exp(2*u.b) - 4], start = {a: 1, b: 1})
let slopes = gradient(u => (u.a - 2)^2 + (u.a*exp(u.b) - 3)^2 + (u.a*exp(2*u.b) - 4)^2, fit)
check abs(slopes.a) < 1e-13 and abs(slopes.b) < 1e-13
