// The NURBS Book: Corner control points of the bicubic tensor T ((10.42))
geo 1
let along_u = (0, 9, 3)
let along_v = (9, 0, 3)
let corner = (0, 0, 3)
let side_u = line(corner, corner + along_u)
let side_v = line(corner, corner + along_v)
let same_u = line(along_u, along_u)
let same_v = line(along_v, along_v)
surface s = coons_bicubic(
    u = [side_u, translate(side_u, along_v)],
    v = [side_v, translate(side_v, along_u)],
    cross_u = [same_v, same_v],
    cross_v = [same_u, same_u],
)
check [s.points[0][0], s.points[1][0]] ~= [(0, 0, 3), (0, 3, 4)] within 5e-11
check [s.points[0][1], s.points[1][1]] ~= [(3, 0, 4), (3, 3, 5)] within 5e-11
