// The size of a start says little of the sizes over which a function bends, in whichever direction.
let sizes = [1e-12, 1e-9, 1e-6, 0.001, 1, 30, 1000, 1e6]
let starts = [...sizes, ...[for s in sizes: -s]]
fn least(f, size) = every(starts, f = s => abs(minimize(f, start = {a: s}).a) ~= size within 1e-3 * size)

// Whose fall rounding hides beside the start, and what lies beyond a maximum between two valleys.
check least(u => 1 - 1e-7*u.a^2 + 1e-9*u.a^4, sqrt(50))
check least(u => 1 - 1e-12*u.a^2 + 1e-20*u.a^4, sqrt(0.5e8))
check least(u => u.a^4 - 2*u.a^2, 1)

// Far away, by any power of the start.
check least(u => -u.a + 1e-10*u.a^2, 5e9)
check least(u => -u.a + 1e-20*u.a^2, 5e19)
check least(u => 1/u.a^2 + u.a^2, 1)
check least(u => 1/u.a^2 + 1e-12*u.a^2, 1000)
check minimize(u => -u.a - u.b + 1e-10*(u.a^2 + u.b^2), start = {a: 1e-9, b: 1e-9}) ~= {a: 5e9, b: 5e9} within 1e4

// From far away, where one unknown comes to its place long before the other.
check minimize(u => (u.a - 3)^2 + (u.b - 2)^2, start = {a: 1e6, b: 1}) ~= {a: 3, b: 2}
check minimize(u => 100*(u.b - u.a^2)^2 + (1 - u.a)^2, start = {a: 1e6, b: 1e6}) ~= {a: 1, b: 1} within 1e-6
check minimize(u => (u.a - 2)^4, start = {a: 1e6}).a ~= 2 within 1e-3
check minimize(u => u.a^4 + u.b^4 - 2*u.a*u.b, start = {a: 1e6, b: 1e6}).b^2 ~= 0.5 within 1e-6

// A level that is come down to at a place is a least value: any place of it is.
check minimize(u => max(1e4 - u.a, 0)^2 + 1, start = {a: 1}).a >= 1e4 - 1e-3
check minimize(u => max(u.a - 3, 0), start = {a: 30}).a <= 3

// What a function answers at once is not asked more often.
check minimize(u => (u.a - 3)^2, start = {a: 1}, report = true).evaluations < 20
check minimize(u => (u.a - 3)^2 + (u.b + 1)^2, start = {a: 1, b: 2}, report = true).evaluations < 40
