let rings = [for z in 0..2: circle((0, 0, z), 1)]
let spine = circle((5, 0, 0), 5)
surface few_places = skin(rings, closed = true, spine = spine, at = [0, 0.5, 1])
surface pinched = skin([rings[0], (0, 0, 0.5), rings[1]])
surface twice = skin([rings[0], rings[1], rings[1], rings[2]])
