surface s = bilinear((0, 0), (0, 1), (1, 0), (1, 1))
mesh m = grid_mesh(s, 10000, 10000)
