// A coordinate has no unit, and neither has what is found by coordinates: their product with a length is
// told without one.
let p = (3, 4)
print solve(x => p.x - x, within = 0..5) * 1mm
print solve(x => 3 - x, within = 0..5) * 1mm
print solve(x => p.x * 1mm - x, within = 0mm..5mm)
print solve(u => [p.x - u.a, 2 - u.b], start = {a: 1, b: 4}).b * 1mm
print solve(x => p.x - x, within = 0..5, all = true)[0] * 1mm
print round(minimize(x => (x - p.x)^2, within = 0..5), 4) * 1mm
print round(minimize(x => (x[0] - p.x)^2 + (x[1] - 1)^2, start = [0, 5])[1], 4) * 1mm
print lerp(1mm, 3mm, p.x / 4)
print lerp(1mm, 3mm, 0.5)
print [for t in [0.25, 0.5]: lerp(1mm, 2mm, t)]
print [for t in [p.x, p.y]: lerp(1mm, 2mm, t)]

// What comes near to zero and does not touch it is no root, however it is asked for.
check len(solve(x => (x - 1)^2 + 1e-13, within = 0..3, all = true)) == 0
check solve(x => (x - 1)^2, within = 0..3) == 1
check solve(x => (x^2 - 2)^2 * exp(x), within = 0..3) ~= sqrt(2)

// Zero itself is such a place as well, wherever the range begins.
let touching = [x => x^2, x => x * x, x => x^4, x => abs(x), x => 1 - cos(x) + x^2, x => cosh(x) - 1 + x^2]
let ranges = [-1..2, -10..25, -0.3..0.7, -1..1]
check every(touching, f => every(ranges, r => abs(solve(f, within = r)) < 1e-7))
check every(touching, f => every(ranges, r => len(solve(f, within = r, all = true)) == 1))
