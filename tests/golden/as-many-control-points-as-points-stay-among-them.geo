points p = [for i in 0..99: (i, sin(i / 5))]
/// With as many control points as points the fit passes them, and with nearly as many it stays beside them.
let whole = approximate(p, control_points = 100, parameters = "uniform")
check report(whole).deviation.max < 1e-9
check every([90, 94, 96, 98, 99, 100], f = k => report(approximate(p, control_points = k, parameters = "uniform")).deviation.max < 1e-2)
check every([94, 98, 100], f = k => bounds(approximate(p, control_points = k)).max.y < 1.01)
check report(approximate([for i in 0..49: (i, sin(i / 5))], degree = 2, control_points = 50)).deviation.max < 1e-9

let grid = [for i in 0..59: [for j in 0..3: (i, j, sin(i / 5))]]
check bounds(approximate(grid, control_points = {u: 60, v: 4})).max.z < 1.01
