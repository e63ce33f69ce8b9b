geo 1
curve a = circle((0, 0), 3)

print line_tangent((1, 0), a)
print line_tangent((1, 0), (2, 0))
print line_tangent((5, 0), a, near = (0, 0))
print line_tangent((5, 0, 1), circle((0, 0), 3, normal = (0, 1, 0)))
print line_tangent(a, a)
print line_tangent(a, line((5, 0), (7, 1)))
print line_tangent(a, XY)
print arc_tangent(a, circle((20, 0), 3), 2)
print arc_tangent(line((0, 0), (5, 0)), line((0, 4), (5, 4)), 2)
print arc_tangent(a, (5, 0), 0)
print arc_tangent((0, 0), (5, 0), 10)
