curve c = circle((0, 0), radus = 2, form = "9-points", form = "7-square")
