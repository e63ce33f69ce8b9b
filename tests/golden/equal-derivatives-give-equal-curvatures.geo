// Pieces of one curve or surface agree in all derivatives, and so in all that is told by arc length.
let wave = bezier((0, 0), (1, 2), (3, 3), (4, 0))
let far = interpolate([for i in 0..9: (1e4 + 3*i, 100*sin(i), i^2)], degree = 5)
fn told(pieces) = [for k in [continuity(pieces[0], pieces[1])]: [k.c, k.g]]
check told(split(wave, 0.3)) == [[3, 3]]
check told(split(wave, 0.001)) == [[3, 3]]
check told(split(far, 0.37)) == [[3, 3]]
check continuity(bezier((0, 0), (1, 1), (0, 1), (1, 0))).g == 0
