surface strip = parametric((u, v) => ((2 + v*cos(u/2))*cos(u), (2 + v*cos(u/2))*sin(u), v*sin(u/2)), 0..tau, -1/2..1/2)
print orient([strip])
surfaces pages = [for a in [0, 90, 180]: plane_patch((0, 0), polar(1, a * 1deg), (0, 0, 1))]
print orient(pages)
print orient([])
