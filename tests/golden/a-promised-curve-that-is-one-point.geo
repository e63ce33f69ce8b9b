// A warning where it is promised, and none where it is a part of something.
curve c = line((1, 2), (1, 2))
let still = line((1, 2), (1, 2))
surface s = coons(u = [line((0, 0), (4, 0)), line((2, 3), (2, 3))], v = [line((0, 0), (2, 3)), line((4, 0), (2, 3))])
print c, s(0.5, 1)
