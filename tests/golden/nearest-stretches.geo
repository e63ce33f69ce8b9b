// A stretch that is all as near has no nearest point, and is no four places either.
curve round = circle((0, 0), 2)
curve turned = arc((0, 0), 2, 30deg, 120deg)
print closest(round, (0, 0))
print closest(turned, (0, 0))
check closest(round, (1e-3, 0)).count == 1 "off the centre there is one"
check closest(line((0, 0), (4, 0)), (2, 1)).count == 1
