let u = [line((0, 0), (4, 0)), line((0, 3), (4, 3))]
let v = [line((0, 0), (0, 3)), line((4, 0), (4, 3))]
let up = line((0, 3), (0, 3))
let along = line((4, 0), (4, 0))
surface slanted = coons_bicubic(
    u = u,
    v = v,
    cross_u = [up, up],
    cross_v = [along, line((5, 0), (4, 0))],
)
surface positions = coons_bicubic(u = u, v = v, cross_u = u, cross_v = v)
surface twisted = coons_bicubic(
    u = u, v = v,
    cross_u = [bezier((0, 3), (0, 3, 1), (0, 3)), up], cross_v = [along, along],
    twists = "error",
)
surface missing = coons_bicubic(u = u, v = v, cross_u = [up], cross_v = [along, along])
