check interpolate((0, 0), (2, 4)).degree == 1
check interpolate((0, 0), (1, 1), (2, 4)).degree == 2
check interpolate([(0, 0), (1, 1), (2, 4)], parameters = "uniform")(0.75) ~= (1.5, 2.25) within 1e-15
check interpolate((0, 0), (1, 1), (2, 4), (3, 1)).degree == 3
check interpolate([(0, 0), (1, 1), (2, 4)], degree = 5).degree == 2
check interpolate([(0, 0), (1, 1), (2, 4)], ends = "not-a-knot").degree == 2
// Tangents make up for the points that are missing.
check interpolate([(0, 0), (1, 0)], tangents = [(0, 3), (0, -3)]).points ~= [(0, 0), (0, 1), (1, 1), (1, 0)] within 1e-15
