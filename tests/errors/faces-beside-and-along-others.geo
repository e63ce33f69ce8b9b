geo 1
face tube = face(cylinder((0, 0), 2, 3))

print offset(tube, -2.5)
print offset(tube, 1, tolerance = 0)
print continuity(tube, face(plane_patch((5, 0), (1, 0), (0, 1))))
print continuity(tube, cylinder((0, 0), 2, 3))
print continuity(tube, tube, angle = 0deg)
print volume(solid(sphere((0, 0), 1)), accuracy = 0)
print volume(solid(box((0, 0), (1, 1, 1))), accuracy = 1e-18)
print faces(sphere((0, 0), 1)), vertices(tube)
