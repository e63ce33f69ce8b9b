curve large = scale(circle((0, 0), 1e300), 1e300)
mesh net = translate(grid_mesh(bilinear((0, 0), (0, 1e308), (1e308, 0), (1e308, 1e308)), 1, 1), (1e308, 0))
