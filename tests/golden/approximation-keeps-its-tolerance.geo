// Distances are to a fine polygon of the curve, which lies within 1e-6 of it.
fn to_segment(q, a, b) = {
    let along = clamp(dot(q - a, b - a) / dot(b - a, b - a), 0, 1)
    distance(q, a + along * (b - a))
}
fn misses(fit, data) = {
    let ends = [for t in linspace(fit.domain.start, fit.domain.end, 1201): fit(t)]
    max([for q in data: min([for i in 0..<1200: to_segment(q, ends[i], ends[i + 1])])])
}

// The NACA 0012 at 69 points.
fn half(x) = 0.6 * (0.2969 * sqrt(x) - 0.1260 * x - 0.3516 * x^2 + 0.2843 * x^3 - 0.1036 * x^4)
let xs = cosspace(0, 1, 35)
let foil = [...[for x in reverse(xs): (x, half(x))], ...[for x in xs[1..-1]: (x, -half(x))]]
curve coarse = approximate(foil, tolerance = 1e-3)
curve fine = approximate(foil, tolerance = 1e-4)
check len(foil) == 69
check len(coarse.points) <= 15
check len(fine.points) <= 20
check misses(coarse, foil) <= 1e-3 + 1e-6
check misses(fine, foil) <= 1e-4 + 1e-6
check coarse.start == foil[0] and coarse.end == foil[68]

// Noise is not followed.
let noise = random(201, seed = 3)
let measured = [for i in 0..200: (i / 10, sin(i / 10) + 0.1 * (noise[i] - 0.5))]
curve smooth = approximate(measured, tolerance = 0.06)
check len(smooth.points) <= 20
check misses(smooth, measured) <= 0.06 + 1e-6

// A corner, points at one place, points on a line, a closed outline.
let corner = [for i in 0..40: (i, abs(i - 20))]
check misses(approximate(corner, tolerance = 0.01), corner) <= 0.01 + 1e-6
let doubled = [(0, 0), (1, 1), (1, 1), (2, 0), (3, 1), (4, 2)]
check misses(approximate(doubled, tolerance = 1e-5), doubled) <= 2e-5
check len(approximate([for i in 0..20: (i, 2 * i)], tolerance = 1e-9).points) == 4
let ring = [for i in 0..72: polar(1, i * 5deg)]
curve round = approximate(ring, tolerance = 1e-3)
check len(round.points) <= 12 and misses(round, ring) <= 1e-3 + 1e-6
// Listed parameters stay.
curve listed = approximate([for t in 0..30: (t, sin(t / 5))], parameters = 0..30, tolerance = 1e-3)
check max([for t in 0..30: distance(listed(t), (t, sin(t / 5)))]) <= 1e-3
