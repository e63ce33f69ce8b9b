// A plane, and a pipe: exact, with the net of the original.
surface plate = bilinear((0, 0), (0, 1), (2, 0), (2, 1))
print offset(plate, -3, 1e-6).points
check offset(plate, 0, 1e-6).points == plate.points
surface pipe = ruled(circle((0, 0), 2), circle((0, 0, 1), 2))
surface wall = offset(pipe, 0.25, 1e-6)
check wall.knots_u == pipe.knots_u and report(wall).exact
check every(linspace(0, 1, 17), u => norm(wall(u, 0)) ~= 2.25 within 1e-14)

// A trough that bends with radius 1 along its bottom, seen from inside.
surface trough = bezier([[(-1, 0, 0.5), (-1, 1, 0.5)], [(0, 0, -0.5), (0, 1, -0.5)], [(1, 0, 0.5), (1, 1, 0.5)]])
surface lining = offset(trough, 0.5, 1e-7)
check norm(lining(0.25, 0.3) - trough(0.25, 0.3)) ~= 0.5 within 1e-7
check lining(0.5, 0.5) ~= (0, 0.5, 0.5) within 1e-7
check report(lining).deviation.max < 1e-7 and not report(lining).exact
// Beyond that radius it turns back, which is told.
surface too_far = offset(trough, 2, 1e-4)
check report(too_far).radius ~= 1 within 1e-6

// Functions have offsets, too: a sphere by its formula, poles included.
surface globe = parametric((u, v) => (cos(u) * cos(v), sin(u) * cos(v), sin(v)), 0..tau, -pi/2..pi/2)
surface shell = offset(globe, 0.5, 1e-6)
check every([for u in linspace(0, tau, 9), v in linspace(-pi/2, pi/2, 9): [u, v]], p => norm(shell(p[0], p[1])) ~= 1.5 within 1e-6)
