// What needs one line from start to end says where a curve or surface jumps, and how to part it.
geo 1

curve j = bspline([(0, 0), (1, 1), (2, 0), (5, 4), (6, 5), (7, 4)], degree = 2, knots = [0, 0, 0, 1, 1, 1, 2, 2, 2])
curve beside = offset(j, 0.1)
surface tube = sweep(circle((0, 0), 0.1), j)
let comb = curvature_comb(j)
mesh plate = planar_mesh(j)
mesh wall = tessellate(extrude(j, (0, 0, 1)))
