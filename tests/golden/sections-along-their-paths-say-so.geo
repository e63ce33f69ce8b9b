// A circle in the plane of x and y has the path in its plane: a strip, covered twice.
surface strip = sweep(circle((0, 0), 1), line((0, 0, 0), (5, 0, 0)))
surface moved = sweep(circle((0, 0), 1), line((0, 0, 0), (5, 0, 0)), frame = "translate")
// None of these is one.
surface tube = sweep(circle((0, 0), 1, normal = (1, 0, 0)), line((0, 0, 0), (5, 0, 0)))
surface prism = sweep(circle((0, 0), 1), line((0, 0, 0), (0, 0, 5)), frame = "translate")
surface sheet = sweep(line((0, -1, 0), (0, 1, 0)), line((0, 0, 0), (5, 0, 0)))
surface slanted = sweep(circle((0, 0), 1, normal = (1, 0, 1)), line((0, 0, 0), (5, 0, 0)))
