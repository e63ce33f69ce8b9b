// A wheel hub: primitives put together, with a fillet turned between them, and holes for the bolts.
//
//     virote run wheel-hub.geo
//     virote run wheel-hub.geo --set bolts=6 --set bore=24mm

geo 1
unit mm

param bore   = 20mm in 8mm..30mm    "Diameter of the bore"
param barrel = 44mm in 40mm..60mm   "Diameter of the barrel"
param flange = 110mm in 90mm..160mm "Diameter of the flange"
param bolts  = 5                    "Number of bolts"

let length    = 60mm
let thickness = 10mm
let fillet    = 6mm
let pitch     = (barrel + flange) / 4 // the radius of the bolts' circle
let hole      = 5mm                   // the radius of a bolt's hole

let foot = (0, 0, 0)

// The flange: its rim, and below it the bearing face, a disc without the bore and the bolts' holes. A face
// that lies level looks up; this one looks down.
let drilled = [for k in 0..<bolts: polar(pitch, k * 1turn / bolts)]
surface rim     = cylinder(foot, flange / 2, thickness)
face    bearing = flip(face(region(
    circle(foot, flange / 2),
    holes = [circle(foot, bore / 2), ...[for p in drilled: circle(p, hole)]],
)))

// The barrel stands on the flange; a quarter of a torus's tube runs from one to the other.
let root = barrel / 2 + fillet
curve    round = arc((root, 0, thickness + fillet), fillet, 180deg, 270deg, normal = (0, -1, 0))
surface  blend = revolve(reversed(round))
// The top is drilled: a ring, cut by the holes; the ring between them stays.
surface  ring  = revolve(line((flange / 2, 0, thickness), (root, 0, thickness)))
surfaces holes = [for p in drilled: cylinder(p, hole, thickness)]
let drills     = [for p in drilled: cylinder(p - (0, 0, 1), hole, thickness + 2)]
face     top   = trim(ring, by = drills, keep = polar(root + 0.5, 0.5turn / bolts) + (0, 0, thickness))
surface  shell = cylinder((0, 0, thickness + fillet), barrel / 2, length - thickness - fillet)
surface  lip   = cone((0, 0, length), barrel / 2, barrel / 2 - 2, 2)
surface  mouth = revolve(line((barrel / 2 - 2, 0, length + 2), (bore / 2, 0, length + 2)))
// Turned from above downward, the bore looks inward, away from the metal.
surface  inner = revolve(line((bore / 2, 0, length + 2), (bore / 2, 0, 0)))
let metal      = [rim, bearing, top, blend, shell, lip, mouth, inner, ...holes]
// A rubber ring in the corner of the rim.
surface seal   = torus((0, 0, thickness), flange / 2, 1.5mm)

// Each part starts where the one before ends.
let around = linspace(0, 1, 17)
fn rings(s, v) = [for u in around: s(u, v)]
check rings(rim, 1) ~= rings(ring, 0)
check rings(ring, 1) ~= rings(blend, 0) within 1e-12
check rings(blend, 1) ~= rings(shell, 0) within 1e-12
check rings(shell, 1) ~= rings(lip, 0) within 1e-12
check rings(lip, 1) ~= rings(mouth, 0) within 1e-12

// And the fillet leaves both sides smoothly: level on the flange, upright at the barrel.
check [for u in around: normal(blend, u, 0)] ~= [for u in around: (0, 0, 1)] within 1e-12 "level on the flange"
check [for u in around: normal(blend, u, 1).z] ~= [for u in around: 0] within 1e-12       "upright at the barrel"

// All of it looks away from the metal, and the bolts keep clear of the barrel and the rim.
check normal(rim, 0, 0.5) ~= (1, 0, 0)
check normal(bearing, 0, bore / 2 / 1mm + 1) ~= (0, 0, -1)
check normal(inner, 0, 0.5) ~= (-1, 0, 0)
check normal(mouth, 0.3, 0.5) ~= (0, 0, 1)
check root < pitch - hole           "the bolts clear the fillet"
check pitch + hole < flange / 2 - 3 "the bolts clear the rim"
check bore < barrel - 8             "the barrel's wall is thick enough"
check bolts * (2 * hole + 4) < 2 * pi * pitch "there is room between the bolts"

// What is drilled is gone, and the rest closes around the metal, whose volume has a closed form: discs,
// the fillet by Guldin's rule, the lip's cone, less the bore.
check area(top) ~= pi * (flange^2 / 4 - root^2 - bolts * hole^2)
let corner = (1 - pi / 4) * fillet^2                                        // of a square, less a quarter of a disc
let arm    = root - fillet * (1 - (10 - 3 * pi) / (12 - 3 * pi))            // its centre of gravity from the axis
let solid  = pi * (flange^2 / 4 - bolts * hole^2) * thickness +
    pi * barrel^2 / 4 * (length - thickness) + 2 * pi * arm * corner +
    pi * 2mm / 3 * (barrel^2 / 4 + barrel / 2 * (barrel / 2 - 2) + (barrel / 2 - 2)^2) -
    pi * bore^2 / 4 * (length + 2mm)
print volume(metal)
check volume(metal) ~= solid within 1e-6 * solid

mesh hub = tessellate(
    [...metal, seal],
    tolerance = 0.1mm,
)
print hub
export hub to "wheel-hub.obj"
