curve c = circle((0, 0), radius = 1, center = (0, 0))
