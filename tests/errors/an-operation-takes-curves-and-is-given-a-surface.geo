surface s = sphere((0, 0), 1)
print tangent_line(s, 0.5)
print tangent_plane(circle((0, 0), 1), 0.5)
