curve c = clamped((0, 0), (1, 1), (2, 0))
curve d = bezier([])
curve e = polyline((0, 0))
