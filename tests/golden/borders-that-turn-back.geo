// A quarter of a disc taken from a square leaves two thorns, at whose tips the border turns back. Beside discs that touch
// there is a crevice, at whose bottom it does so as well.
let turns = [0deg, 10deg, 33deg, 77deg, 123deg, 200deg, 270deg]
region thorns = region([line((0, 0), (2, 0)), reversed(arc((2, 2), 2, 180deg, 270deg)), line((0, 2), (0, 0))])
region crevice = region([arc((1, 0), 1, 180deg, 360deg), arc((3, 0), 1, 180deg, 360deg), line((4, 0), (4, 2)), line((4, 2), (0, 2)), line((0, 2), (0, 0))])
// Grown by 0.1: a strip along two sides and one inside of the arc, a quarter of a disc and two halves at the corners.
let grown = 4 - pi + 0.1 * 4 + (4 - 1.9^2) * pi / 4 + (1/4 + 1) * pi * 0.01
check every([for turn in turns: area(offset(rotate(thorns, turn), 0.1)[0]) ~= grown within 1e-12])
// Shrunk by 0.1 it is what two lines and an arc of 2.1 leave.
let wedge = asin(1.9 / 2.1) - asin(sqrt(2.1^2 - 1.9^2) / 2.1)
let shrunk = 1.9^2 - 1.9 * sqrt(2.1^2 - 1.9^2) - 2.1^2 / 2 * (wedge / 1rad)
check every([for turn in turns: area(offset(rotate(thorns, turn), -0.1)[0]) ~= shrunk within 1e-12])
// The grown halves of discs overlap in half a lens below the crevice; shrunk, its bottom is half a disc away.
let lens = 1.21 * (acos(1 / 1.1) / 1rad) - sqrt(0.21)
check every([for turn in turns: area(offset(rotate(crevice, turn), 0.1)[0]) ~= 8.8 + pi / 2 * 0.01 + 1.21 * pi - lens within 1e-12])
check every([for turn in turns: area(offset(rotate(crevice, turn), -0.1)[0]) ~= 3.8 * 1.9 - pi / 2 * 0.01 + 0.81 * pi within 1e-12])
// The same rounded corners whichever way it is turned.
check every([for turn in turns: area(fillet(rotate(thorns, turn), 0.1)) ~= area(fillet(thorns, 0.1)) within 1e-12])
check every([for turn in turns: area(fillet(rotate(crevice, turn), 0.1, at = [rotate((2, 0), turn)])) ~= area(fillet(crevice, 0.1, at = [(2, 0)])) within 1e-12])
// A circle of 0.3 between two discs of 1.75 that touch one another and, in 3.5, nothing else: its centre is
// sqrt(2.05^2 - 1.75^2) beyond. What it adds is a triangle without three sectors.
region letter = region([line((0, 0), (0, 7)), line((0, 7), (2.5, 7)), reversed(arc((2.5, 5.25), 1.75, -90deg, 90deg)), reversed(arc((2.5, 1.75), 1.75, -90deg, 90deg)), line((2.5, 0), (0, 0))])
let reach = sqrt(2.05^2 - 1.75^2)
let half = asin(reach / 2.05) / 1rad
let added = 1.75 * reach - 1.75^2 * half - 0.3^2 * (pi/2 - half)
check area(fillet(letter, 0.3, at = [(2.5, 3.5)])) ~= area(letter) + added within 1e-12
check every([for p in difference(region(polyline((-1, -1), (1, -1), (1, 1), (-1, 1), closed = true)), region(circle((0, 0), 1))): area(offset(p, -0.02)[0]) ~= 0.15841686398489 within 1e-12])
