let cubic = conic_kind(bezier((0, 0), (1, 2), (2, 2), (3, 0)))
let straight = conic_kind(conic((0, 0), (1, 1), (2, 2), 1))
let emptied = conic_kind(conic((0, 0), (1, 1), (2, 0), 0))
let mixed = conic_kind(nurbs((0, 0), (1, 1), (2, 0), (3, -1), (4, 0), weights = [1, 1, 1, 2, 1], degree = 2, knots = [0, 0, 0, 1, 1, 2, 2, 2]))
