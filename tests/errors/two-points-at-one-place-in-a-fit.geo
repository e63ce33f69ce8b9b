let data = [(0, 0), (1, 1), (1, 1), (2, 0), (3, 1)]
curve a = interpolate(data)
curve b = interpolate(data, parameters = "foley")
curve c = lagrange(data, parameters = "centripetal")
curve d = interpolate([(1, 1), (1, 1)])
