curve cusp = bezier((0, 0), (1, 1), (0, 1), (1, 0))
print classify(cusp, 0.5), tangent(cusp, 0.5), tangent(cusp, 0.5, side = "left")
curve bend = bezier((0, 0), (1, 1), (2, -1), (3, 0))
print classify(bend, 0.5), classify(bend, 0.2), curvature(bend, 0.5)
// x^4 bends to one side all the way, although its curvature vanishes at 0.
print classify(bezier((-1, 1), (-1/2, -1), (0, 1), (1/2, -1), (1, 1)), 0.5)
print classify(polyline((0, 0), (1, 0), (1, 1), (0, 0)), 0), classify(polyline((0, 0), (1, 0), (1, 1)), 0)
print [is_straight(bend), is_planar(bend), is_closed(bend)]
print [is_straight(line((1, 2, 3), (4, 5, 6))), is_planar(circle((0, 0), 1, normal = (1, 2, 3))), is_closed(circle((0, 0), 1))]
