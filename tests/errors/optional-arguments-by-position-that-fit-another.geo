surface s = revolve(line((1, 0), (1, 0, 2)), 360)
curve c = circle((0, 0), 1, 5)
