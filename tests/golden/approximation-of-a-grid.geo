// A grid of a biquadratic surface gives it back; corners are kept.
fn f(u, v) = (u, v, u^2 - 2*u*v + v^2/2)
let grid = [for i in 0..7: [for j in 0..5: f(i, j)]]
surface exact = approximate(grid, degree = 2, control_points = {u: 5, v: 4}, parameters = {u: 0..7, v: 0..5})
check exact(3.3, 2.2) ~= f(3.3, 2.2) within 1e-12
check len(exact.points) == 5 and len(exact.points[0]) == 4

let noise = random(48, seed = 7)
let rough = [for i in 0..7: [for j in 0..5: grid[i][j] + (0, 0, 0.01 * noise[6*i + j])]]
surface near = approximate(rough, control_points = 4)
check near(0, 0) ~= rough[0][0] within 1e-14 and near(1, 1) ~= rough[7][5] within 1e-13
check near.degree_u == 3 and near.degree_v == 3

// Each row and column alike: as with one curve.
let profile = [(0, 0), (1, 2), (2, 3), (4, 3), (5, 1), (7, 0), (8, 2)]
curve one = approximate(profile, control_points = 5)
surface extruded = approximate([for p in profile: [for z in 0..4: p + (0, 0, z)]], control_points = {u: 5, v: 2}, degree = {u: 3, v: 1})
check [for row in extruded.points: row[0]] ~= one.points within 1e-13
