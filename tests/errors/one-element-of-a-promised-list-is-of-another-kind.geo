curves xs = [line((0, 0), (1, 0)), 5]
