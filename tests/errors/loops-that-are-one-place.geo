// A loop within the tolerance bounds nothing: all of the surface is no answer.
geo 1

let patch = plane_patch((0, 0), (4, 0), (0, 4))
print area(face(patch, [circle((2, 2), 1e-7)]))
print area(face(patch, [reversed(circle((2, 2), 1e-7))]))
print area(face(patch, [circle((0.5, 0.5), 1e-8)], space = "uv"))
