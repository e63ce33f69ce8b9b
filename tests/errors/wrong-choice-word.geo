curve c = circle((0, 0), 1, form = "9-points")
curve d = circle((0, 0), 1, form = "square")
