// A line that goes on where an arc begins to bend away is within the tolerance of it for a thousandth.
region disc = region(circle((0.5, 1), 0.5))
region slot = region([line((-0.5, 0.5), (0.5, 0.5)), arc((0.5, 1), 0.5, -90deg, 90deg), line((0.5, 1.5), (-0.5, 1.5)), arc((-0.5, 1), 0.5, 90deg, 270deg)])
region block = region(polyline([(0, 1.5), (1, 1.5), (1, 3), (0, 3)], closed = true))
fn whole(a, b) = sum([for r in union(a, b): area(r)])
fn left(a, b) = sum([for r in union(a, b): sum([for z in difference(r, b): area(z)])])
let turns = [for k in 0..9: 7deg*k]
check every(turns, t => whole(rotate(disc, t), rotate(slot, t)) ~= (1 + pi/4) * 1mm^2 within 1e-12mm^2)
check every(turns, t => whole(rotate(block, t), rotate(slot, t)) ~= (2.5 + pi/4) * 1mm^2 within 1e-12mm^2)
check every(turns, t => left(rotate(slot, t), rotate(disc, t)) ~= 1mm^2 within 1e-12mm^2)
check every(turns, t => left(rotate(slot, t), rotate(block, t)) ~= (1 + pi/4) * 1mm^2 within 1e-12mm^2)
print [for r in union(slot, block): difference(r, slot)]
