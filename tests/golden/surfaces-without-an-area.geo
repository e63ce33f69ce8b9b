// Surfaces that are no more than a curve or a point are made, and told of.
let dot = bilinear((1, 2), (1, 2), (1, 2), (1, 2))
let ring = ruled(circle((0, 0), 1), circle((0, 0), 1))
let bar = bezier([[(0, 0), (1, 0)], [(2, 0), (3, 0)]])
let rail = bspline([for i in 0..5: [for j in 0..5: (i + 2*j, 0, 0)]])
check [area(dot), area(ring), area(bar), area(rail)] == [0, 0, 0, 0]
// A cone's tip, a patch without a corner and a narrow strip have one.
check area(bilinear((0, 0), (0, 0), (1, 0), (1, 1))) ~= 0.5
check area(ruled(line((0, 0), (1, 0)), line((0, 1e-6), (1, 1e-6)))) ~= 1e-6
