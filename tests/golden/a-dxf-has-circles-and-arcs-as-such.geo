// A plate for the laser: its border is one closed path of lines and arcs, its hole a circle. An arc that turns
// clockwise, a circle on a slanted plane, a path that stays open and an ellipse, which is none.
unit mm
let corners = region(polyline([(0, 0), (40, 0), (40, 20), (0, 20)], closed = true))
let plate = difference(offset(corners, 5), region(circle((10, 10), 4)))
curve bend = reversed(arc((60, 10), 5, 10deg, 200deg))
curve slanted = circle((80, 10, 3), 5, normal = (1, 1, 1))
curve hook = join([line((100, 0), (100, 10)), arc((105, 10), 5, 180deg, 0deg, normal = (0, 0, 1)), line((110, 10), (110, 5))])
let bitten = difference(region(polyline([(150, 0), (170, 0), (170, 20), (150, 20)], closed = true)), region(circle((150, 10), 4)))
curve oval = ellipse((130, 10), 8, 4)

check area(plate[0]) ~= 40*20 + 2*5*(40 + 20) + pi*5^2 - pi*4^2 "a plate with round corners and a hole"
check length(hook) ~= 10 + 5*pi + 5 "a half turn between two lines"
check area(bitten[0]) ~= 20*20 - pi*4^2/2 "a bite, whose arc turns the other way"

export plate, bend, slanted, hook, bitten, oval to "plate.dxf"
