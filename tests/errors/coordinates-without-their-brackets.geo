curve a = line(0, 0, 1, 0)
curve b = circle(0, 0, 5)
curve c = line(0, 0, 0, 1, 2, 3)
curve d = arc_through(0, 0, 1, 1, 2, 0)
curve e = line(0, 0, 1)
curve f = circle(2 * pi,
    1 + 1, 3)
