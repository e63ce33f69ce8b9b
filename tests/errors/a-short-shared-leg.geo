// A stretch is shared however short it is.
geo 1

print intersect(polyline((0, 0), (1, 0), (1.01, 0), (1.02, 1)), polyline((1, -1), (1, 0), (1.01, 0), (1.02, -1)))
