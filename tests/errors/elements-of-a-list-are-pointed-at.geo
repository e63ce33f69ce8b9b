curve a = join([line((0, 0), (1, 0)), line((1, 0), (2, 0)), line((2, 1), (3, 1))])
curve b = interpolate((0, 0), (1, 1), (1, 1), (2, 0))
curve c = nurbs((0, 0), (1, 1), (2, 0), weights = [1, -2, 1], degree = 2)
surface d = clamped([[(0, 0), (1, 0)], [(0, 1)]], degree = 1)
curve e = polyline([(0, 0), "p", (1, 1)])
let parts = [line((0, 0), (1, 0)), line((2, 0), (3, 0))]
curve f = join(parts)
