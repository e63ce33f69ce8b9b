curve c = circle((0, 0), 0)
curve d = circle((0, 0), -1)
curve e = circle((0, 0), 1, normal = (0, 0, 0))
print unit_vector((0, 0))
