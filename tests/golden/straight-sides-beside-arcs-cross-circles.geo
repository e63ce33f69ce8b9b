// A straight side has the degree of the arc beside it: what two regions share and what they are together are as large as both.
geo 1

let disc = region(circle((0, 0), 1))
let short = arc(
    (-0.8227251901190247, -1.1540628662436927),
    0.6734959610231179,
    94.52045098653396deg,
    349.40860448520243deg,
)
let long = arc(
    (0.673390383264449, 0.20027880038607226),
    1.4804116618450207,
    341.2542546062279deg,
    489.32391395069965deg,
)
fn half(a) = region([a, line(a.end, a.start)])
fn total(regions) = sum([for r in regions: area(r)])
fn adds_up(a, b) =
    abs(total(union(a, b)) + total(intersection(a, b)) - area(a) - area(b)) < 1e-12 * area(a)
check every([half(short), half(long)], b => adds_up(disc, b))
check total(intersection(disc, half(short))) > 0.0078mm^2
check total(intersection(disc, half(long))) > 0.0177mm^2
