let a = bspline((0, 0), (1, 1), (2, 0), degree = 2, knots = [0, 1])
let b = bspline((0, 0), (1, 1), (2, 0), knots = [0, 1])
let c = nurbs([(0, 0), (1, 1), (2, 0)], degree = 2, knots = [0, 0, 0, 0, 1, 1, 1])
let d = bspline([[(0, 0), (1, 1)], [(0, 1), (1, 2)]], degree = 1, knots = { u: [0, 1], v: [0, 0, 1, 1] })
