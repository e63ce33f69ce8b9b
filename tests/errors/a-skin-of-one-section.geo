surface s = skin([circle((0, 0), 1)])
curve c = coons_bspline((0, 0))
