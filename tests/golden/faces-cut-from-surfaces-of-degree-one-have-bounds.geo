surface s = clamped([[(0, 0, 0), (0, 1, 0.5)], [(1, 0, 0), (1, 1, 2)], [(2, 0, -1), (2, 1, 0)]], degree = 1)
faces f = split(s, by = plane((1.5, 0.9, 0), (1, 1, 1)))
print len(f)
check every(f, f = p => -1 <= bounds(p).min.z and bounds(p).max.z <= 2 and 0 <= bounds(p).min.x and bounds(p).max.x <= 2)
