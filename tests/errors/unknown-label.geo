curve c = circle((0, 0), radus = 2)
