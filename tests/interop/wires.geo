// Curves of all forms, and points.
unit cm
curve leg = line((0, 0, 0), (4, 1, 2)) with (color = "#c04020", layer = "lines")
curve path = polyline((0, 5), (3, 7), (5, 5, 1), (8, 6))
curve loop = polyline((0, 10), (3, 12), (5, 10), closed = true)
curve cubic = bezier((10, 0), (12, 4), (14, -3, 2), (16, 0)) with (color = "steelblue", layer = "lines")
curve high = bezier((10, 5), (11, 8), (12, 5, 3), (13, 9), (14, 4), (15, 6), (16, 5))
curve round = circle((20, 0), 3)
curve oval = ellipse((30, 0), 4, 2)
curve part = arc((40, 0), 3, 20deg, 200deg)
curve open_spline = coons_bspline((20, 10), (21, 13), (23, 9), (25, 12), (27, 10))
curve closed_spline = bspline((30, 10), (32, 13), (34, 10), (32, 7), closed = true)
curve through = interpolate((40, 10), (41, 12), (43, 11), (44, 14))
curve infinite = nurbs((50, 0), (0, 1), (52, 0), weights = [1, 0, 1], degree = 2)
curve wave = parametric(t => (50 + t, 10 + sin(t), cos(t)), 0..6)
points marks = [(0, 20), (1, 20, 3), (2, 20)]
export all to "wires.step"
export all to "wires.igs"
export all to "wires.ply"
export all to "wires.glb"
export all to "wires.gltf"
export all to "wires.dxf"
export all to "wires.obj"
export all to "wires-exact.obj" with (free_form = true)
export all to "wires.svg"
export leg, path, loop, cubic, high, round, oval, part, open_spline, closed_spline, through, infinite, marks to "wires.json"
