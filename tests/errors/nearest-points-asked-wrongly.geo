geo 1
surface saddle = bilinear((0, 0), (0, 1), (1, 0), (1, 1, 1))
let no_point = closest(saddle, 3)
let no_geometry = closest((0, 0), (1, 1))
let nothing = closest(saddle)
