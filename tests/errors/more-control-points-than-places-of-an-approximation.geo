geo 1
let places = [(0, 0), (1, 1), (2, 0), (3, 1), (4, 0), (5, 1), (6, 0)]
curve near = approximate([...places, (6, 0), (6, 0), (6, 0), (6, 0)], control_points = 10)
