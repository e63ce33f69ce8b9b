geo 1

// What a surface lies on, whatever made it; a bump on it makes it none.
print describe(sphere((1,2,3), 2)).form, describe(cylinder((0,0,0), 1, 2)).form
print describe(scale(sphere((0, 0, 0), 1), (1, 2, 3))).form
print describe(revolve(line((1, 0), (2, 0, 3)))).form
print describe(scale(revolve(line((1, 0), (2, 0, 3))), (1, 2, 3))).form
print describe(revolve(line((1, 0, -1), (1, 2, 3)))).form
print describe(torus((0,0,0), 3, 1)).form
print describe(bilinear((0, 0, 0), (0, 1, 1), (1, 0, 1), (1, 1, 0))).form
print describe(bilinear((0, 0, 0), (0, 1, 0), (1, 0, 0), (1, 1, 0))).form
print describe(bilinear((0, 0, 0), (0, 1, 0), (1, 0, 0), (0.2, 0.2, 0))).form
print describe(bezier([[(0, 0, 0), (0, 2, 1), (0, 4, 0)], [(2, 0, 1), (2, 2, 4), (2, 4, 1)], [(4, 0, 0), (4, 2, 1), (4, 4, 0)]])).form
print describe(bezier([[(0,0,0),(0,1,0),(0,2,1)],[(1,0,0),(1,1,0),(1,2,1)],[(2,0,1),(2,1,1),(2,2,2)]])).form
print describe(extrude(bezier((0,0),(1,2),(2,0)), (1,1,3))).form
