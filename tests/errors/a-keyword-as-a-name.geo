let points = [(0, 0), (1, 2), (3, 2), (4, 0)]
curve c = bezier(points)
