geo 1
// A path without a corner sweeps a surface without a crease: over its seam, and at joints where
// it only keeps its direction.
tolerance 1e-6

curve ring = circle((0, 0, 0), 0.3, normal = (1, 0, 0))

curve closed_path = interpolate([(3, 0, 0), (0, 3, 1), (-3, 0, 0), (0, -3, 1)], closed = true)
surface tube = sweep(ring, closed_path)
check continuity(closed_path).g == 2  "the path bends on evenly over its seam"
check continuity(tube).g == 2         "and so does the tube"
check continuity(tube).angle < 1e-7deg
surface coarse = sweep(ring, closed_path, tolerance = 1e-3)
check continuity(coarse).g >= 1       "a coarse tube too has no crease at its seam"
surface freely = sweep(ring, closed_path, keep_path = false)
check continuity(freely).g == 2

curve bends = join([
    bezier((0, 0, 0), (1, 1, 0), (2, 1, 1), (3, 0, 1)),
    bezier((3, 0, 1), (5, -2, 1), (6, -2, 2), (7, 0, 2)),
])
check continuity(bends).g == 1           "one direction, two curvatures"
check continuity(sweep(ring, bends)).g == 1

curve starts_straight = join([
    line((-3, 0), (0, 0)),
    bezier((0, 0, 0), (1, 0, 0), (2, 1, 1), (3, 3, 1)),
])
check continuity(sweep(ring, starts_straight)).g == 1

// The path itself stays where it was.
let axis = sweep(line((0, 0, 0), (0, 0.3, 0)), closed_path)
check max([for i in 0..50: norm(axis(0, i / 50) - closed_path(i / 50))]) < 1e-14
print continuity(tube).g
