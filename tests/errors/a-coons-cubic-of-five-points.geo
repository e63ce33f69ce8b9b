curve c = coons_cubic((0, 0), (1, 2), (3, 0), (4, 4), (5, 5))
