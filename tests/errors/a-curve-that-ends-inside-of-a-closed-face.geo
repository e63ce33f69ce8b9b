geo 1

// It goes over the seam twice, and divides nothing.
let wall = cylinder((0, 0, 0), 1, 3)
print len(split(wall, by = rotate(helix((0, 0, 0.5), 1, 1, 2), 30deg)))
