// A gasket for a laser: one outline around two bores, bolt holes, and the path of the beam beside it.
//
//     virote run gasket.geo
//     virote run gasket.geo --set bolts=6 --set kerf=0.2mm

geo 1
unit mm

param big   = 60mm in 40mm..90mm      "Diameter of the large bore"
param small = 30mm in 20mm..50mm      "Diameter of the small bore"
param apart = 80mm in 60mm..140mm     "Distance of the bores"
param rim   = 12mm in 8mm..20mm       "Width of the material around them"
param bolts = 8 in 4..16              "Bolts around the large bore"
param kerf  = 0.15mm in 0mm..0.5mm    "Width of the beam"

let [left, right] = [(0, 0), (apart, 0)]

// Arcs of this radius, between a flange and the waist, touch the waist so far from the middle of the bore; without
// arcs it is the corner that is there. The flanges leave room for both arcs, or cover the waist.
let round = 10mm
fn reach(bore, round) = sqrt((bore / 2 + rim + round)^2 - (rim + round)^2)
fn both(round) = reach(big, round) + reach(small, round)
let _room = assert(
    both(round) < apart or apart <= both(0mm),
    "the waist is too short for its arcs: move the bores apart, or take less",
)

// What both flanges cover, with a waist between them, and its corners rounded.
region flange = region(circle(left, big / 2 + rim))
region boss   = region(circle(right, small / 2 + rim))
region waist  = region(polyline([(0, -rim), (apart, -rim), (apart, rim), (0, rim)], closed = true))
regions whole = union(flange, boss, waist) with (hidden = true)
region outline = fillet(whole[0], round) with (hidden = true)

// The bores and the bolts' holes are cut out of it.
let pitch = big / 2 + rim / 2
regions bores = [
    region(circle(left, big / 2)),
    region(circle(right, small / 2)),
] with (hidden = true)
regions holes = [
    for k in 0..<bolts: region(circle(left + polar(pitch, (k + 0.5) * 1turn / bolts), 2.2mm))
]
    with (hidden = true)
regions cut    = difference(outline, bores, holes) with (hidden = true)
region  gasket = cut[0] with (color = "#4e79a7")

// The beam takes half of its width on both sides: outlines grow, holes shrink.
regions path = offset(gasket, kerf / 2) with (color = "red")

check len(whole) == 1 and len(cut) == 1         "it is one piece"
check len(gasket.holes) == bolts + 2            "every hole is inside of the material"
check len(offset(gasket, -1.2mm)) == 1          "no bridge is narrower than 2.4mm"
check area(gasket) ~= area(outline) - pi * (big^2 + small^2) / 4 - bolts * pi * (2.2mm)^2
check contains(gasket, left + polar(pitch, 0deg)) == "inside"
check centroid(flange) ~= left within 1e-9

print gasket, area(gasket), length(path[0])
export gasket to "gasket.svg"
export path to "gasket.dxf"
