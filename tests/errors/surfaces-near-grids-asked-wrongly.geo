geo 1

let grid = [for i in 0..6: [for j in 0..6: (i, j, i * j)]]
let neither = approximate(grid)
let both = approximate(grid, tolerance = 0.1, control_points = 5)
let nothing = approximate(grid, tolerance = 0)
let below = approximate([for i in 0..6: [for j in 0..6: (i / 3, j / 3, i^3 * j)]], tolerance = 1e-20)
let few = approximate([[(0, 0), (1, 0)], [(0, 1), (1, 1)]], tolerance = 0.1)
let measured = approximate(grid, tolerance = 3deg)
