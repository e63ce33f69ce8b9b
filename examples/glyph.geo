// The letter "a" and the digit "8" as regions: outlines of quadratic and cubic pieces, as fonts hold them, filled
// by the even-odd rule; a stencil is cut out of a sheet, and a bold face is an offset.

geo 1
unit mm

// Outlines by their pieces: each a list of points, the end of one the start of the next.
fn outline(pieces) = join([for p in pieces: if len(p) == 2 then line(p[0], p[1]) else bezier(p)])

let bowl = outline([
    [(8, 0), (12, 0), (15, 1.5), (16, 3)],
    [(16, 3), (16, 0.5)],
    [(16, 0.5), (20, 0.5)],
    [(20, 0.5), (20, 12)],
    [(20, 12), (20, 18), (16, 20), (11, 20)],
    [(11, 20), (6, 20), (3, 18), (2, 14)],
    [(2, 14), (6, 13.5)],
    [(6, 13.5), (6.7, 15.7), (8.5, 16.6), (11, 16.6)],
    [(11, 16.6), (14, 16.6), (16, 15.5), (16, 12.5)],
    [(16, 12.5), (16, 11.8)],
    [(16, 11.8), (10, 11.5), (1, 11.5), (1, 5.5)],
    [(1, 5.5), (1, 2), (4, 0), (8, 0)],
])
let counter = outline([
    [(16, 8.8), (12, 8.6), (5.2, 8.8), (5.2, 5.6)],
    [(5.2, 5.6), (5.2, 4), (6.6, 3.2), (8.8, 3.2)],
    [(8.8, 3.2), (13, 3.2), (16, 5.5), (16, 8.8)],
])
let ring = c => [circle(c, 5.5), circle(c, 2.6)]
regions a     = regions([bowl, counter])
regions eight = union([
    for c in [(30, 5.5), (30, 14.5)]: region(circle(c, 5.5), holes = [circle(c, 2.2)])
])
print a, eight, [for r in [...a, ...eight]: area(r)]
check len(a) == 1 and len(a[0].holes) == 1
check contains(a[0], (9, 6)) == "outside" and contains(a[0], (3, 5.5)) == "inside"
check len(eight[0].holes) == 2
// Two circles of radius 5.5, 9 apart, share a lens; the holes of 2.2 stay clear of it.
let half = acos(4.5 / 5.5)
check area(eight[0]) ~= 2 * pi * (5.5^2 - 2.2^2) - 2 * 5.5^2 * (half / 1rad - sin(half) * cos(half))

// A bold face, and a stencil in a sheet.
regions bold = offset(a[0], 0.6)
check area(bold[0]) > area(a[0]) + 0.4mm * length(a[0])
region sheet = region(polyline([(-4, -4), (40, -4), (40, 24), (-4, 24)], closed = true))
regions stencil = difference(sheet, [...a, ...eight])
check sum([for r in stencil: area(r)]) ~= area(sheet) - area(a[0]) - area(eight[0])
check len(stencil) == 4 "the counters of the letters fall out"

export stencil to "stencil.svg"
export bold to "bold.dxf"
