// Where the first parameter is a list of points, they may stand as the arguments.
let a = (0, 0)
let b = (1, 2)
let c = (2, 0)
check bezier(a, b, c).points == bezier([a, b, c]).points
check polyline(a, b, c, closed = true).closed
check clamped(a, b, c, degree = 2).degree == 2
check centroid(a, b, c) ~= (1, 2/3)
check max(1, 3, 2) == 3
check max([1, 3, 2]) == 3
check min(4, 2) == 2
