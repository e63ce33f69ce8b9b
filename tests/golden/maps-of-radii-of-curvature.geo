// The least and the greatest radius of curvature in colours, by closed forms.

// A sphere of radius R: R in every direction, one value and white.
let ball = [for kind in ["min_radius", "max_radius"]: curvature_map(sphere((0, 0), 2), kind)]
check every(ball, map => every(map.values, r => r ~= 2 within 1e-9))
check [for map in ball: [map.min, map.max]] ~= [[2, 2], [2, 2]] within 1e-9
check [for map in ball: [map.below, map.above]] == [[0, 0], [0, 0]]
check every(ball, map => every(map.scale, s => s.color == (1, 1, 1)))

// A cylinder: its own radius around, and without bound along, where the scale ends at ten times
// the size: norm((4, 4, 5)) is that of its box.
let round = curvature_map(cylinder((0, 0), 2, 5), "min_radius")
check [round.min, round.max] ~= [2, 2] within 1e-9
check every(round.values, r => r ~= 2 within 1e-9)
let straight = curvature_map(cylinder((0, 0), 2, 5), "max_radius")
check every(straight.values, r => r == none)
check [straight.min, straight.max] ~= [10*norm((4, 4, 5)), 10*norm((4, 4, 5))] within 1e-9
check [straight.below, straight.above] == [0, len(straight.values)]

// A torus with R > 2r: r around the tube everywhere; the other radius is |ρ/cos v|, without bound
// on the two circles on top and below, and R − r inside.
let ring = torus((0, 0), 3, 1)
let tube = curvature_map(ring, "min_radius")
check [tube.min, tube.max] ~= [1, 1] within 1e-9
let other = curvature_map(ring, "max_radius")
check other.min ~= 2 within 1e-9
check other.max ~= 10*norm((8, 8, 2)) within 1e-9
check other.above > 0
let known = [for i in 0..<len(other.values) if other.values[i] != none: i]
check len(known) < len(other.values)
check every(known, i => { let p = other.mesh.vertices[i]; let rho = hypot(p.x, p.y); abs(rho - 3)/rho*other.values[i] ~= 1 within 1e-9 })
let flat = [for i in 0..<len(other.values) if other.values[i] == none: other.mesh.vertices[i].z]
check every(flat, z => abs(z) ~= 1 within 1e-9)
// What has no bound has the colour of the largest.
check other.mesh.colors[[for i in 0..<len(other.values) if other.values[i] == none: i][0]] == other.scale[8].color

// On a scale of its own what is beyond is counted, and has the colours of the ends.
let near = curvature_map(ring, "max_radius", range = 3..5)
check [near.min, near.max] == [3, 5]
let n_below = len([for r in near.values if r != none and r < 3: r])
let n_above = len([for r in near.values if r == none or r > 5: r])
check [near.below, near.above] == [n_below, n_above]
check near.below > 0 and near.above > 0

// A plane is flat in all directions.
let plate = curvature_map(plane_patch((0, 0), (1, 0), (0, 1)), "min_radius")
check plate.values == [none, none, none, none] and plate.above == 4
