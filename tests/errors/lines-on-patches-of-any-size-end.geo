surface large = bilinear((0, 0), (0, 1e9), (1e9, 0), (1e9, 1e9, 1e9))
print contours(large, (0, 0, 1), [0.3e9])
print section(large, plane((0, 0, 0.3e9), (0, 0, 1)))
print section(box((0, 0), 1e155), plane((0, 0, 1e154), (1, 0, 1)))
