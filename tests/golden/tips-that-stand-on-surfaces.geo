// Tips and poles that stand on another surface touch it in one point: that is told, wherever they stand, and nothing is divided.
geo 1

let plate = plane_patch((-3, -3), (6, 0), (0, 6))
let turned = rotate(plate, 33deg, axis = (1, 0.3, 0.2))
let cup = cone((0, 0, 0), 0, 1, 2)
let hat = cone((0, 0, -2), 1, 0, 2)
let spike = revolve(bezier((0, 0, 1), (0.5, 0, 1.2), (0.6, 0, 2)), axis = (0, 0, 1))
let ball = sphere((0, 0), 1)

// In the middle of a plate and beside it, on a plate that is turned, on a sphere; two tips; a pole on either side.
check intersect(plate, cup) == []
check intersect(plate, cone((0.5, 0.25, 0), 0, 1, 2)) == []
check intersect(turned, rotate(cup, 33deg, axis = (1, 0.3, 0.2))) == []
check intersect(ball, spike) == []
check intersect(hat, cup) == []
check intersect(plate, sphere((0, 0, 1), 1)) == []
check intersect(plate, sphere((0, 0, -1), 1)) == []

// What stands on a face leaves all of it, and so does a face that is stood on.
fn all_of(part, whole) = abs(area(part) / area(whole) - 1) < 1e-12
fn is_whole(face, cutter) = all_of(trim(face, by = cutter, keep = "outside"), face) and trim(face, by = cutter, keep = "inside") == none
check is_whole(plate, solid(cup, cap = true))
check is_whole(plate, solid(sphere((0, 0, 1), 1)))
check is_whole(plate, solid(sphere((0, 0, -1), 1)))
check is_whole(ball, solid(spike, cap = true))
check is_whole(spike, solid(ball))
check is_whole(hat, solid(cup, cap = true))
check is_whole(cup, solid(hat, cap = true))
check all_of(trim(cup, by = XY, keep = "above"), cup) and trim(cup, by = XY, keep = "below") == none
check all_of(trim(hat, by = XY, keep = "below"), hat) and trim(hat, by = XY, keep = "above") == none
