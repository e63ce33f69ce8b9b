// Faces of a box, each second one turned inward, and the same as one mesh.
surfaces faces = [for i in 0..5: if i % 2 == 0 then flip(box((0, 0, 0), (1, 2, 3))[i]) else box((0, 0, 0), (1, 2, 3))[i]]
export faces to "faces.stl" with (binary = false, tolerance = 1, angle = 180deg)
export tessellate(faces, tolerance = 1, angle = 180deg) to "mesh.obj"
export faces to "faces.dxf"
// Inward as a whole.
surface inward = flip(sphere((0, 0), 1))
export inward to "inward.obj" with (tolerance = 1, angle = 90deg)
// A cavity in a body faces inward and stays so, and what is open stays as it is.
surface outside = sphere((0, 0), 2)
export [outside, inward] to "cavity.glb"
surface open = flip(plane_patch((0, 0), (1, 0), (0, 1)))
export open to "open.obj"
