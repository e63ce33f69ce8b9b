// A slit that leads to a hole, in lines and in arcs; spikes outward and inward, twice and once; a line that runs back.
region slit = region(polyline([(0, 0), (4, 0), (4, 4), (2, 4), (2, 3), (1, 3), (1, 1), (3, 1), (3, 3), (2, 3), (2, 4), (0, 4)], closed = true))
region keyhole = region([circle((0, 0), 2), line((2, 0), (1, 0)), circle((0, 0), 1), line((1, 0), (2, 0))])
region spike = region(polyline([(0, 0), (2, 0), (2, 1), (3, 1), (2, 1), (2, 2), (0, 2)], closed = true))
region notch = region(polyline([(0, 0), (2, 0), (2, 1), (1, 1), (2, 1), (2, 2), (0, 2)], closed = true))
region twice = region(polyline([(0, 0), (2, 0), (2, 1), (3, 1), (2, 1), (3, 1), (2, 1), (2, 2), (0, 2)], closed = true))
region back = region([line((0, 0), (4, 0)), line((4, 0), (4, 4)), line((4, 4), (0, 4)), line((0, 4), (0, -1)), line((0, -1), (0, 0))])
