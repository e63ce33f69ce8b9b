curve c = clamped((0, 0), (1, 1), (2, 0), (3, 1))
print insert_knot(c, 0.5, times = 9)
print insert_knot(c, 0)
