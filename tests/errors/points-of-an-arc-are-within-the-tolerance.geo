print arc_through((0, 0), (1e-9, 0), (1, 1))
