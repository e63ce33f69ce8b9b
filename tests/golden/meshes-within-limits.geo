// Planes need their corners, however they are parametrized; edges and turns of the normal on request.
surface plate = bilinear((0, 0), (0, 1), (1, 0), (2, 1))
print tessellate(plate, tolerance = 1e-9)
print tessellate(plate, max_edge = 0.5)

// A list whose edges are one curve is one mesh, whatever their degrees and knots are.
surface left = bezier([[(0, 0, 0), (0, 1, 1), (0, 2, 0)], [(1, 0, 1), (1, 1, 3), (1, 2, 1)]])
surface right = bezier([[(1, 0, 1), (1, 1, 3), (1, 2, 1)], [(2, 0, 0), (2, 1, 1), (2, 2, 0)]])
mesh roof = tessellate([left, insert_knot(elevate(right, v = 2), v = 0.3)], tolerance = 0.001)
check check_mesh(roof).boundaries == 1
check check_mesh(roof).components == 1
check check_mesh(roof).degenerate == 0

// A sphere is closed, its poles and its seam too.
mesh ball = tessellate(sphere((0, 0, 0), 10), tolerance = 0.01)
check check_mesh(ball).closed
check check_mesh(ball).euler == 2
check deviation(ball, sphere((0, 0, 0), 10)).max <= 0.01

// By the angle alone: a tolerance that allows everything.
print len(tessellate(cylinder((0, 0), 1, 1), tolerance = 10, angle = 90deg).triangles)
print len(tessellate(cylinder((0, 0), 1, 1), tolerance = 10, angle = 10deg).triangles)
