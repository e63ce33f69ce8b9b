surface one = bezier([[(0, 0), (1, 0), (2, 1)]])
surface empty = bezier([[], []])
surface thin = clamped([[(0, 0), (1, 0), (2, 1), (3, 0)], [(0, 1), (1, 1), (2, 2), (3, 1)]])
