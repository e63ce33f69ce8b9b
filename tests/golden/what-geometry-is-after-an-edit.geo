// Whatever was done to it, describe tells what its coefficients prove.
let c = circle((1, 2), 3)
check describe(c).form == "circle"
check describe(elevate(c, 4)).form == "circle"
check describe(trim(c, 0.1..0.6)).form == "arc"
check describe(bezier((0, 0), (1, 1), (2, 2))).form == "line"
check describe(bezier((0, 0), (1, 1), (2, 0))).form == none
check describe(sphere((0, 0), 2)).form == "sphere"
check describe(elevate(sphere((0, 0), 2), u = 3)).form == "sphere"
check describe(torus((0, 0), 3, 1)).form == "torus"
check describe(cylinder((0, 0), 2, 1)).form == "cylinder"
check describe(flip(bilinear((0, 0), (0, 1), (1, 0), (1, 1)))).form == "plane"
check describe(bilinear((0, 0), (0, 1), (1, 0), (1, 1, 1))).form == "hyperbolic paraboloid"
