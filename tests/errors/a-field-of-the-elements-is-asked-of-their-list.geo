let meetings = intersect(line((0, 0), (1, 1)), line((0, 1), (1, 0)))
print meetings.point
