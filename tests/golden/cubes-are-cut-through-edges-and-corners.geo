// Planes through edges and corners of a cube, where the middles of triangles lie in the plane.
let cube = solid(box((0, 0, 0), (1, 1, 1)))
fn sides(origin, normal) =
    [for keep in ["below", "above"]: volume(cut(cube, plane(origin, normal), keep = keep))]
check sides((1, 0, 0), (1, 1, 0)) ~= [1/2, 1/2] within 1e-12
check sides((0, 0, 0), (1, -1, 0)) ~= [1/2, 1/2] within 1e-12
check sides((0, 0, 0), (1, 0, -1)) ~= [1/2, 1/2] within 1e-12
check sides((1, 0, 0), (1, 1, 1)) ~= [1/6, 5/6] within 1e-12
check sides((1, 0, 0), (1, 1, 0.5)) ~= [7/24, 17/24] within 1e-12
check sides((0, 0, 0), (2, -1, 0)) ~= [1/4, 3/4] within 1e-12
check sides((0, 0, 0), (2, -1, -1)) ~= [1/2, 1/2] within 1e-12
check sides((0.5, 0.5, 0.5), (1, 1, 1)) ~= [1/2, 1/2] within 1e-12

// A plane that touches a corner, an edge or a side leaves all of it on one side.
let touching = [(1, 1, 1), (1, 1, 0), (1, 0, 0)]
check [for n in touching: cut(cube, plane((0, 0, 0), n), keep = "below")] == [none, none, none]
check [for n in touching: volume(cut(cube, plane((0, 0, 0), n), keep = "above"))]
    ~= [1, 1, 1] within 1e-12
check len(section(cube, plane((1, 0, 0), (1, 1, 0)))) == 1
