geo 1
// The last five stand at one place, through which the curve goes whatever their number.
let apart = [(0, 0), (1, 1), (2, 0), (3, 1), (4, 0), (5, 1), (6, 0)]
let crowded = [...apart, (6, 0), (6, 0), (6, 0), (6, 0)]
curve once = approximate(apart, control_points = 6)
curve often = approximate(crowded, control_points = 6)
check often.knots == once.knots
check often.points ~= once.points within 1e-12
