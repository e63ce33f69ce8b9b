geo 1
unit m

// A plate, and sheets that climb from their edges beside it.
surface plate = plane_patch((-1, -1), (4, 0), (0, 4))
fn sheet(first, second) = bezier([[(0, 0, first), (0, 1, second)], [(1, 0, first + 0.1), (1, 1, second + 0.1)]])

// It ends below the plate: both cross beside its edge.
let crossing = intersect(sheet(-5e-7, -5e-7), plate)
check len(crossing) == 1
check length(crossing[0]) ~= 1

// It ends just above one half of it, and below the other: both cross in a corner of it.
let corner = intersect(sheet(-2e-7, 2e-7), plate)
check len(corner) == 1
check length(corner[0]) ~= 0.5

// It ends above, within the tolerance: they touch along that edge.
check len(intersect(sheet(5e-7, 5e-7), plate)) == 0

// It stands on the plate in a corner.
let standing = bezier([[(0, 0, 0), (0, 1, 0.5)], [(1, 0, 0.5), (1, 1, 1)]])
check len(intersect(standing, plate)) == 0

// It ends above by more than the tolerance.
check len(intersect(sheet(2e-6, 2e-6), plate)) == 0

// The same of a function.
let function = parametric((u, v) => (u * 1m, v * 1m, 5e-7m + 0.1m * u), 0..1, 0..1)
check len(intersect(function, plate)) == 0

// Its edge dips twice towards the plate: they touch along each of the dips.
fn t(v) = (v - 0.25) / 0.5
fn dips(v) = 2e-5 * t(v)^2 * (1 - t(v))^2 + 2e-7
let wave = parametric((u, v) => (u * 1m, v * 1m, dips(v) * 1m + 0.1m * u), 0..1, 0..1)
check len(intersect(wave, plate)) == 0
