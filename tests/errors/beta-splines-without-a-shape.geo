let corners = [(0, 0), (1, 2), (3, 2), (4, 0)]
curve back = beta_spline(corners, bias = -1)
curve torn = beta_spline(corners, tension = -12)
curve short = beta_spline(corners[0..2])
