curve a = polyline([[0, 0], [1, 2]])
surface b = extrude(circle((0, 0), 1), 10)
curve c = trim(line((0, 0), (1, 0)), 0)
curve d = mirror(line((0, 0), (1, 1)), "x")
curve e = circle((0, 0), "5")
curve f = reversed([(0, 0), (1, 1)])
let g = (1, 2) + 3
