curve c = bezier((0, 0), (1, 2), (2, 0))
surface s = bilinear((0, 0), (0, 1), (1, 0), (1, 1))
print c(1.5), s(0.5, -1), c((1, 2)), c(1, 2), s(1)
