// Each message names the curves as the script does, tells where and how much, and what would help.
let waterlines = [for z in 0..2: line((0, 0, z), (4, 0, z))]
let frames = [for x in 0..2: line((2*x, 0, 0), (2*x, 0, 2))]
let sheer = line((0, 0, 2.25), (4, 0, 2.25))
let keel = line((0, 0, 0), (4, 0, 0))
// A curve above all others; a grid with a hole; a network of one direction.
surface above = gordon([keel, sheer], frames)
surface hole = gordon(waterlines, [frames[0], line((2, 0, 0), (2, 0, 1.5)), frames[2]])
surface parallel = gordon(waterlines, [for z in 0..1: line((0, 1, z), (4, 1, z))])
// Meeting twice, and running along one another.
surface twice = gordon([waterlines[0], waterlines[2]], [bezier((0, 0, 2), (1, 0, -2), (2, 0, 2)), bezier((2, 0, 2), (3, 0, -2), (4, 0, 2))])
surface together = gordon(waterlines, [frames[0], polyline((2, 0, -1), (2, 0, 0), (3, 0, 0), (3, 0, 2))])
// Neighbours that cross: once, so that the order changes, and twice.
surface once = gordon([keel, line((0, 0, 2), (4, 0, 2))], [frames[0], line((4, 0, 0), (2, 0, 2)), line((2, 0, 0), (4, 0, 2))])
surface again = gordon([keel, bezier((0, 0, 1), (2, 0, -3), (4, 0, 1)), sheer], [for x in [0, 4]: line((x, 0, 0), (x, 0, 2.25))])
// A ring among open curves.
surface mixed = gordon([circle((0, 0, 0), 1), arc((0, 0, 1), 1, 0deg, 350deg)], [for k in 0..2: line((cos(90deg*k), sin(90deg*k), 0), (cos(90deg*k), sin(90deg*k), 1))])
// Nothing, one, and a point.
surface none_across = gordon(waterlines, [])
surface one = gordon([keel], frames)
surface pointed = gordon([keel, line((0, 0, 2), (0, 0, 2))], frames)
