curve c = (1, 2)
surface s = circle((0, 0), 1)
points ps = [(0, 0), 3]
point bezier((0, 0), (1, 1))
