curve shrunk = offset(circle((0, 0), 2), -2)
curve flat = offset(line((0, 0), (1, 0)), 1, normal = (0, 0, 0))
curve upright = offset(line((0, 0, 0), (0, 0, 1)), 1)
curve unitless = offset(line((0, 0), (1, 0)), 30deg)
