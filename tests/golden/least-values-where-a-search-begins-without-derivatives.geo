geo 1
// No derivative passes through a gradient: what this makes of x is x, and what is asked of it are differences.
fn plain(x) = gradient(t => t*x, 1)
fn rosenbrock(v) = 100*(v[1] - v[0]^2)^2 + (1 - v[0])^2
fn off(a, b) = norm((a[0] - b[0], a[1] - b[1]))

// A search that begins at the least value of what is smooth sees no slope; how it bends is no kink.
check off(minimize(v => plain(v[0]^2 + v[1]^2), start = [0, 0]), [0, 0]) < 1e-6
check off(minimize(v => plain((v[0] - 1)^2 + (v[1] - 1)^2), start = [1.0001, 1.0001]), [1, 1])
    < 1e-6
check off(minimize(v => plain(rosenbrock(v)), start = [1, 1]), [1, 1]) < 1e-6
check off(minimize(v => plain(rosenbrock(v)), start = [0, 0]), [1, 1]) < 1e-6

// Forty unknowns between kinks: its dual, a quadratic program, has the same value.
let n = 40
fn chain(v) = sum([for k in 0..<n: abs(v[k] - v[(k + 1)%n])*(1 + k%3) + (v[k] - sin(k*1rad))^2])
check chain(minimize(v => chain(v), start = [for k in 0..<n: k*7%5 - 2])) ~= 16.98760126 within 1e-7
