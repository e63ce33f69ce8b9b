geo 1

let ring = solid(torus((0, 0), 1, 1))
let cones = solid(revolve(polyline((1, 0, 0), (0, 0, 1), (1, 0, 2))), cap = true)
let hole = solid(torus((0, 0), 1, 0.9999995))
let half = solid([revolve(circle((1, 0), 1), axis = (0, 1, 0), angle = 180deg), disc((1, 0), 1), disc((-1, 0), 1)])
