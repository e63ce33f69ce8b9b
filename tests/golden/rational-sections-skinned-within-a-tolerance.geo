geo 1
// Weights that jump from section to section would vanish between them: those sections become
// splines within the tolerance that was asked for, and the surface has no weights.
let weights = [1, 30, 1, 1, 30, 1]
let sections = [for i in 0..5: conic((0, 0, i), (1, 1, i), (2, 0, i), weights[i])]
fn miss(s, c) = max([for k in 0..40: closest(s, c(k / 40)).distance])

surface loose = skin(sections, tolerance = 1e-2)
surface close = skin(sections, tolerance = 1e-4)
check not loose.rational
check not close.rational
check every(sections, c => miss(loose, c) <= 1e-2)
check every(sections, c => miss(close, c) <= 1e-4)
check len(loose.points) < len(close.points)
check report(close).refitted == [1, 4]

// Monotone weights stay positive: nothing is given up.
surface exact = skin(sections, shape = "monotone")
check exact.rational
check every(sections, c => miss(exact, c) <= 1e-14)
print report(exact).refitted
