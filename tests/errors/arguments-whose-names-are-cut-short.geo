curve ring = circle((0, 0), r = 3)
surface pipe = cylinder((0, 0), h = 10, r = 5)
curve coin = circle((0, 0), d = 10)
