let data = [(0, 0), (1, 1), (2, 0), (3, 1)]
curve a = interpolate(data, parameters = [0, 1, 1, 2])
curve b = interpolate(data, parameters = [0, 2, 1, 3])
curve c = interpolate(data, parameters = [0, 1, 2])
curve d = interpolate(data, parameters = "cord")
curve e = interpolate(data, parameters = 3)
curve f = interpolate(data, parameters = [0, 1, 2, 3], closed = true)
curve g = lagrange(data, parameters = [3, 2, 1, 0])
