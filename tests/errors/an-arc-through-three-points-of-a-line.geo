curve straight = arc_through((0, 0), (1, 1), (3, 3))
curve same = arc_through((0, 0), (1, 1), (0, 0))
