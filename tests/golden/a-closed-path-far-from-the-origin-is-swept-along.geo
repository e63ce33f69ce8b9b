let s = translate(interpolate([(1, 0, 0), (2, 2, 1), (0, 3, 0), (-2, 1, -1), (-1, -1, 0), (0, -2, 1)], closed = true), (1e7, 2e7, -1e7))
surface w = sweep(circle((0, 0, 0), 0.1, normal = (1, 0, 0)), s)
check report(w).deviation.max <= 1e-6
