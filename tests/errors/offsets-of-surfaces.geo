surface plate = bilinear((0, 0), (0, 1), (2, 0), (2, 1))
surface roof = bspline([[(0, 0), (0, 1)], [(1, 0, 1), (1, 1, 1)], [(2, 0), (2, 1)]], degree = 1)
// (t², t³, v): the normal leaps along t = 0.
surface cuspidal = bezier([for p in [(1, -1), (-1/3, 1), (-1/3, -1), (1, 1)]: [p, p + (0, 0, 1)]])
let no_tolerance = offset(plate, 1, 0)
let creased = offset(roof, 0.5, 1e-6)
let no_normal = offset(cuspidal, 0.1, 1e-6)
let not_a_length = offset(plate, 30deg, 1e-6)
let missing = offset(plate, 1)
