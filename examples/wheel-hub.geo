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

// The flange: its rim, and below it the bearing face as a flat ring.
surface rim  = cylinder(foot, flange / 2, thickness)
surface face = revolve(line((bore / 2, 0, 0), (flange / 2, 0, 0)))

// The barrel stands on the flange; a quarter of a torus's tube runs from one to the other.
let root = barrel / 2 + fillet
curve    round = arc((root, 0, thickness + fillet), fillet, 180deg, 270deg, normal = (0, -1, 0))
surface  blend = revolve(reversed(round))
surface  top   = revolve(line((flange / 2, 0, thickness), (root, 0, thickness)))
surface  shell = cylinder((0, 0, thickness + fillet), barrel / 2, length - thickness - fillet)
surface  lip   = cone((0, 0, length), barrel / 2, barrel / 2 - 2, 2)
surface  mouth = revolve(line((barrel / 2 - 2, 0, length + 2), (bore / 2, 0, length + 2)))
// Turned from above downward, the bore looks inward, away from the metal.
surface  inner = revolve(line((bore / 2, 0, length + 2), (bore / 2, 0, 0)))
surfaces holes = [for k in 0..<bolts: cylinder(polar(pitch, k * 1turn / bolts), hole, thickness)]
// A rubber ring in the corner of the rim.
surface  seal  = torus((0, 0, thickness), flange / 2, 1.5mm)

// Each part starts where the one before ends.
let around = linspace(0, 1, 17)
fn rings(s, v) = [for u in around: s(u, v)]
check rings(rim, 1) ~= rings(top, 0)
check rings(top, 1) ~= rings(blend, 0) within 1e-12
check rings(blend, 1) ~= rings(shell, 0) within 1e-12
check rings(shell, 1) ~= rings(lip, 0) within 1e-12
check rings(lip, 1) ~= rings(mouth, 0) within 1e-12
check rings(rim, 0) ~= rings(face, 1)

// And the fillet leaves both sides smoothly: level on the flange, upright at the barrel.
check [for u in around: normal(blend, u, 0)] ~= [for u in around: (0, 0, 1)] within 1e-12 "level on the flange"
check [for u in around: normal(blend, u, 1).z] ~= [for u in around: 0] within 1e-12       "upright at the barrel"

// All of it looks away from the metal, and the bolts keep clear of the barrel and the rim.
check normal(rim, 0, 0.5) ~= (1, 0, 0)
check normal(face, 0.3, 0.5) ~= (0, 0, -1)
check normal(inner, 0, 0.5) ~= (-1, 0, 0)
check normal(mouth, 0.3, 0.5) ~= (0, 0, 1)
check root < pitch - hole           "the bolts clear the fillet"
check pitch + hole < flange / 2 - 3 "the bolts clear the rim"
check bore < barrel - 8             "the barrel's wall is thick enough"
check bolts * (2 * hole + 4) < 2 * pi * pitch "there is room between the bolts"

mesh hub = tessellate(
    [rim, face, top, blend, shell, lip, mouth, inner, seal, ...holes],
    tolerance = 0.1mm,
)
print hub
export hub to "wheel-hub.obj"
