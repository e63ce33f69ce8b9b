let grid = [for i in 0..4: [for j in 0..3: (i, j, i * j)]]
let twice = [for i in [0, 1, 1, 2]: [for j in 0..3: (i, j)]]
surface aa = interpolate(twice)
surface bb = interpolate(grid, ends = "clamped")
surface cc = interpolate(grid, ends = {u: "natural", v: "natral"})
surface dd = interpolate(grid, degree = {u: 3, v: 2}, ends = "natural")
surface ee = interpolate(grid, parameters = {u: [0, 1, 2, 3, 4], v: [0, 1, 3, 2]})
surface ff = interpolate(grid, second_pass = "points")
surface gg = approximate(grid)
surface hh = approximate(grid, control_points = 5)
surface ii = approximate(grid, degree = 4, control_points = 4)
surface jj = interpolate([[(0, 0), (1, 0)]])
surface kk = interpolate([[(0, 0), (1, 0)], [(0, 1)]])
