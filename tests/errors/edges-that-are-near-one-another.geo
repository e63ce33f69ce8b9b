geo 1
unit mm

let only = solid(trim(sphere((0, 0), 1), by = XY, keep = "above"))
let slab = cut(solid(box((0, 0, 0), (1, 1, 1))), plane((0, 0, 1.5e-6), (0, 0, 1)))
let thin = solid(box((0, 0, 0), (1, 1, 1.5e-6)))
let touching = solid([...box((0, 0, 0), (1, 1, 1)), ...box((1, 1, 0), (1, 1, 1))])
let more = solid([...box((0, 0, 0), (1, 1, 1)), plane_patch((1, 1, 0), (1, 0, 0), (0, 0, 1))])
