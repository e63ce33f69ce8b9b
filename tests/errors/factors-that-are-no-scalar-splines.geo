curve c = bezier((0, 0), (1, 2), (2, 0))
curve negative = reweight(c, line((1, 0), (-1, 0)))
curve aside = reweight(c, line((1, 0), (2, 1)))
curve elsewhere = reweight(c, polyline((1, 0), (2, 0), (3, 0)))
