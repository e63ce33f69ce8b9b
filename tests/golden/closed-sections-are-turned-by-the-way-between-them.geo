// Sections of a ring, a third of a turn apart: each seems to run against its neighbour, as far as their shapes
// tell, but the way from one to the next passes both in one sense.
let thirds = [for i in 0..2: rotate(circle((3, 0, 0), 1, normal = (0, 1, 0)), i * 120deg)]
let ring = skin(thirds, closed = true)
check report(ring).reversed == []
check volume(ring) ~= volume(skin(thirds, closed = true, align = false)) within 1e-9
// One that runs against the others is found.
check report(skin([thirds[0], reversed(thirds[1]), thirds[2]], closed = true)).reversed == [1]

// The same with corners.
let square = polyline([(2, 0, -1), (4, 0, -1), (4, 0, 1), (2, 0, 1)], closed = true)
let squares = [for i in 0..2: rotate(square, i * 120deg)]
check report(skin(squares, closed = true)).reversed == []
check report(skin([squares[0], squares[1], reversed(squares[2])], closed = true)).reversed == [2]

// A bend by more than a right angle from section to section.
let bend = skin([for a in [0, 95, 180]: rotate(circle((3, 0, 0), 1, normal = (0, 1, 0)), a * 1deg)])
check report(bend).reversed == []

// Two closed edges of a surface.
let band = edge_surface([circle((0, 0), 1), reversed(circle((0, 0, 1), 1))])
check report(band).reversed == [1]
check area(band) ~= 2 * pi within 1e-9
