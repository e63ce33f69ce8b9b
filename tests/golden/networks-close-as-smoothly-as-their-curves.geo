geo 1
// A body of closed rings and guides that meet only roughly, so that all curves are refitted: over
// the seam it goes on as the rings do.
tolerance 1e-6
fn body(s, a) = (
    10*s,
    (0.3 + 1.2*sin(pi*(0.1 + 0.8*s)))*cos(a)*(1 + 0.1*s),
    (0.3 + sin(pi*(0.1 + 0.8*s)))*sin(a) + 0.5*s*s,
)
let rings = [
    for s in [0, 0.13, 0.3, 0.52, 0.77, 1]:
        interpolate([for k in 0..<40: body(s, 2*pi*k/40)], closed = true)
]
let guides = [for a in [0, 1.1, 2.3, 3.4, 4.9]: interpolate([for k in 0..30: body(k/30, a)])]
fn miss(s, lines) = max([for c in lines: max([for t in 0..20: closest(s, c(t / 20)).distance])])

surface skin_of_rings = gordon(u = rings, v = guides, tolerance = 2e-3)
check every(rings, c => continuity(c).g == 2)
check continuity(skin_of_rings).g == 2  "no seam is seen"
check miss(skin_of_rings, [...rings, ...guides]) < 2e-3

// In any order and direction.
surface shuffled = gordon(
    u = [guides[3], reversed(guides[0]), guides[2], guides[4], guides[1]],
    v = [rings[4], rings[0], reversed(rings[2]), rings[1], rings[5], rings[3]],
    tolerance = 2e-3,
)
check continuity(shuffled).g == 2
check miss(shuffled, [...rings, ...guides]) < 2e-3
