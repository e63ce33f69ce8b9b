print arc_through((0, 0), (1, 1e-9), (2, 0))
print normal_line(sphere((0, 0), 1), 0.5)
print tangent_plane(circle((0, 0), 1), 0.5)
