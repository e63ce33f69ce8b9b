// Corners in the data become corners of the curve, and what is straight between costs nothing.
let tent = [for i in 0..40: (i, abs(i - 20))]
curve roof = approximate(tent, tolerance = 1e-3)
check len(roof.points) == 7 and roof(0.5) ~= (20, 0)
check report(roof).corners ~= [0.5] and continuity(roof).g == 0
check report(roof).deviation.max <= 1e-12

// An outline that closes, with points at one place.
let sides = [
    ...[for i in 0..9: (i, 0)], ...[for i in 0..9: (10, i)],
    ...[for i in 0..9: (10 - i, 10)], (0, 10), (0, 10), ...[for i in 1..10: (0, 10 - i)],
]
curve outline = approximate(sides, tolerance = 1e-6)
check outline.closed and len(outline.points) == 13
check corners(outline) ~= [0, 0.25, 0.5, 0.75]

// A short side has fewer points than the degree.
let step = [...[for i in 0..9: (i, 0)], (10, 0), (10, 1), ...[for i in 11..20: (i, 1)]]
check report(approximate(step, tolerance = 1e-6)).deviation.max <= 1e-6

// Noise has no corners.
let noise = random(300, seed = 7)
let rough = [for i in 0..299: (i / 20, sin(i / 20) + 0.05 * noise[i])]
check report(approximate(rough, tolerance = 0.05)).corners == []
check len(approximate(rough, tolerance = 0.05).points) < 30
// Of a bend that is sampled coarsely neither.
check report(approximate([for i in 0..12: polar(1, i * 30deg)], tolerance = 0.01)).corners == []
