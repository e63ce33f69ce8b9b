geo 1
unit mm

// A prism over a triangle: by Euler 6 - 9 + 5 = 2.
solid prism = extrude(region(polyline([(0, 0), (3, 0), (0, 4)], closed = true)), (0, 0, 2))
check len(prism.vertices) == 6 and len(prism.edges) == 9 and len(prism.faces) == 5
check sum([for e in prism.edges: length(e)]) ~= 2*12 + 3*2
check edges(prism) == prism.edges
check genus(prism) == 0

// A step of a pipe: rims of two circles each end in no corner.
solid pipe = solid([cylinder((0, 0), 2, 5), cylinder((0, 0), 1, 5)], cap = true)
check len(pipe.edges) == 4 and genus(pipe) == 1
check sum([for e in pipe.edges: length(e)]) ~= 12*pi within 1e-6
check [for x in [0, 1, 1.5, 2, 2.5]: contains(pipe, (x, 0, 2))] == ["outside", "border", "inside", "border", "outside"]
check closest(pipe, (0, 0, 2)).distance ~= 1
check closest(pipe, (3, 0, 6)).point ~= (2, 0, 5)

// Cut through: the parts have edges where the plane was.
solid half = cut(pipe, plane((0, 0, 0), (1, 0, 0)))
check genus(half) == 0 and len(half.vertices) == 8 and len(half.edges) == 12
check closest(half, (1, 1.5, 2)).distance ~= 1
print prism, pipe, half, half.vertices[0]
export prism to "prism.step"
