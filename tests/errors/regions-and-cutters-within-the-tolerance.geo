geo 1
// What is smaller than the tolerance, or known worse than that, is told and not left out.
let disc = region(circle((0, 0), 1))
let square = region(polyline([(0, 0), (1, 0), (1, 1), (0, 1)], closed = true))

print difference(disc, region(circle((0, 0), 1e-7)))
print union(disc, region(circle((0, 3), 1e-6)))
print fillet(square, 1e-7)
print offset(disc, 1e12)
print region(circle((1e160, 0), 1))
print split(plane_patch((-2, -2), (4, 0), (0, 4)), by = sphere((0, 0), 1e-9))
print trim(sphere((0, 0), 1e9), by = sphere((1e9, 0, 0), 1e-9), keep = (0, 0, 1e9))
print volume(extrude(disc, (0, 0, 1e15)))
