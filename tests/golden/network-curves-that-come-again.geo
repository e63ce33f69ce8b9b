// Where the curves across close, one at their seam often stands at both ends of the list, as drawn
// or the other way around; it counts once, in any order.
fn upward(a) = line((cos(a), sin(a), 0), (cos(a), sin(a), 4))
let rings = [for z in [0, 2, 4]: circle((0, 0, z), 1)]

surface drawn = gordon(u = rings, v = [upward(0), upward(2), upward(4), upward(0)])
surface shuffled = gordon(
    u = [rings[1], reversed(rings[2]), rings[0]],
    v = [upward(4), reversed(upward(0)), upward(2), upward(0)],
)
print report(drawn).repeated_v, report(drawn).repeated_u
check report(drawn).repeated_v == [3]
check report(shuffled).repeated_v == [3]
check report(shuffled).v[2].curve == 2
fn is_round(s) = every(
    [for u in linspace(0, 1, 20): norm(s(u, 0.3) - (0, 0, s(u, 0.3).z)) - 1],
    miss => abs(miss) < 2e-6,
)
check is_round(drawn) and is_round(shuffled)
check continuity(drawn).g >= 2 and continuity(shuffled).g >= 2
// One that comes again a little aside is within the tolerance too.
surface aside = gordon(
    u = rings,
    v = [upward(0), upward(2), upward(4), translate(upward(0), (0, 4e-7, 0))],
    tolerance = 1e-6,
)
check report(aside).repeated_v == [3]
check report(aside).deviation <= 6e-7
