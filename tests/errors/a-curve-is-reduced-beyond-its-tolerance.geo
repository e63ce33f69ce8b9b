print reduce(clamped((0, 0), (1, 1), (2, 0), (3, 1)), 1e-9)
