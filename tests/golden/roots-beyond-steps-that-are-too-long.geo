// The first step leads to where there is no value, and is taken shorter.
check solve(u => [exp(u[0]) - 1e3], start = [0])[0] ~= ln(1e3) within 1e-12
check solve(u => [exp(u[0]) - 1e10, u[1] - u[0]], start = [0, 0]) ~= [ln(1e10), ln(1e10)] within 1e-12
check solve(u => [cosh(u[0]) - 1e6], start = [1])[0] ~= ln(1e6 + sqrt(1e12 - 1)) within 1e-12
check solve(u => [acos(u[0])/1rad - 0.001], start = [0])[0] ~= cos(0.001rad) within 1e-12
// Parameters of curves end.
let a = bezier((0, 0), (1, 2), (3, -1), (4, 1))
let b = bezier((0, 1), (1, -1), (3, 2), (4, -0.5))
fn apart(u) = { let d = a(u.t) - b(u.s)
  [d.x, d.y] }
let met = solve(apart, start = {t: 0.3, s: 0.6})
check distance(a(met.t), b(met.s)) < 1e-9
// A narrow valley is left by steps that go up first.
check solve(u => [1e3*(u[1] - u[0]^2), 1 - u[0]], start = [-1.2, 1]) ~= [1, 1] within 1e-12
check solve(u => [1e6*(u[1] - u[0]^2), 1 - u[0]], start = [-1.2, 1]) ~= [1, 1] within 1e-9
