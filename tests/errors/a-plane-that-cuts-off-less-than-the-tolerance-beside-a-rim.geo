geo 1
unit mm
tolerance 1e-6
let wall = cylinder((0, 0, -1), 1, 2)
print len(split(wall, by = plane((-1, 0, 1 - 1e-7), (-1, 0, 1))))
print len(split(cone((0, 0), 1, 0, 2), by = plane((0, 0, 2 - 1e-7), (0, 0, 1))))
