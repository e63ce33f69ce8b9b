let data = [(0, 0), (1, 1), (2, 0), (3, 1)]
let right = (1, 0)
curve a = interpolate(data, derivatives = [right, right, right])
curve b = interpolate(data, derivatives = [right, right, right, right], degree = 4)
curve c = interpolate(data, derivatives = [right, right, right, right], ends = "natural")
curve d = interpolate(data, derivatives = [right, right, right, right], closed = true)
