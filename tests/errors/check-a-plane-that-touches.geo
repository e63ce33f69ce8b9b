// A touch in a point is no curve: a warning tells where it is.
let poles = contours(sphere((0, 0), 1), (0, 0, 1), [-1, 1])
check len(poles) == 0
let facing = isophotes(sphere((0, 0), 1), (0, 1, 0), [0deg])
check len(facing) == 1
