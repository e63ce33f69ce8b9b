// Nothing overflows on the way to a result that is a number.
check abs(norm((3e200, 4e200)) / 5e200 - 1) < 1e-15
check abs(distance((3e200, 0), (0, 4e200)) / 5e200 - 1) < 1e-15
check unit_vector((3, 4)) == (0.6, 0.8)
check linspace(-1e308, 1e308, 3) == [-1e308, 0, 1e308]
check abs(length(line((0, 0), (3e200, 4e200))) / 5e200 - 1) < 1e-12
check abs(length(line((0, 0), (3e-200, 4e-200))) / 5e-200 - 1) < 1e-12
