// The edge of the first surface that lies inside the second is one of their curves; a part of it is not found.
surface waves = bspline([for i in 0..5: [for j in 0..5: (2 * i, 2 * j, sin(2 * i) * cos(j))]])
surface wave = parametric((u, v) => (u, v, 0.3 * sin(u)), -1..10, -1..11)
print len(intersect(waves, wave))
