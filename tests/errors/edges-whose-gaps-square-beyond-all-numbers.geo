surface a = edge_surface([line((0, 0), (1e200, 0)), line((0, 1), (0, 2)), line((3, 3), (4, 4))])
