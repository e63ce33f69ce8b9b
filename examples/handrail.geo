// The handrail of a spiral stair: a tube along a helix that bends level at both ends, without a jump in its
// curvature; with what the bender needs, and a post on every step.
//
//     virote run handrail.geo
//     virote run handrail.geo --set rise=3.2m --set steps=17

geo 1
unit mm

param rise = 2800mm in 2000mm..4000mm     "From floor to floor"
param steps: integer = 15 in 10..24       "Number of risers"
param radius = 900mm in 600mm..2000mm     "From the axis of the stair to the rail"
param turn   = 300deg in 90deg..350deg    "By how much the stair turns, to the left"
param height = 900mm in 800mm..1200mm     "Of the rail over the edges of the steps"
param tube   = 42.4mm in 25mm..60mm       "Diameter of the tube"
param wall   = 2.6mm in 1.5mm..5mm        "Thickness of its wall"
param level  = 350mm in 200mm..600mm      "How far the ends go on"

// The last riser ends at the upper floor: there is one tread less. The rail follows the edges of all.
let riser = rise / steps
let way   = rise - riser
let climb = atan(way / (radius * turn / 1rad))
check 140mm <= riser and riser <= 200mm                                "steps that one can walk"

curve helical = helix((0, 0, riser + height), radius, way * (1turn / turn), turn / 1turn)

// An end has the direction and the curvature of the helix where it begins, and is level and straight where it
// ends: a Bézier curve of degree 5, whose three outer points on either side say so.
let [foot, along, bend] = [
    helical.start,
    tangent(helical, 0),
    curvature(helical, 0) * normal(helical, 0),
]
let out = foot - level * (0, 1, tan(climb) / 2)
curve lower = bezier(
    out, out + level / 5 * (0, 1), out + level * 2/5 * (0, 1),
    foot - level * 2/5 * along + level^2 / 20 * bend, foot - level / 5 * along, foot,
)
// The other end is the same, turned over half way up.
let middle = helical(0.5)
curve upper = reversed(rotate(lower, 180deg, axis = (middle.x, middle.y), about = (0, 0, middle.z)))
curve axis = join([lower, helical, upper])
check continuity(axis).g >= 2                                          "no jump in the curvature"

// A helix is bent as a circle of r / cos² of its climb, and twisted by tan of that as much.
let [bent, twisted] = [curvature(helical, 0.5), torsion(helical, 0.5)]
check bent ~= cos(climb)^2 / radius within 1e-9
check twisted ~= bent * tan(climb) within 1e-8
check length(helical) ~= hypot(way, radius * turn / 1rad) within 1e-3
let tightest = 1 / curvature(axis, maximize(t => curvature(axis, t), within = axis.domain))
check tightest > 4 * tube                                              "the bender can do it"

// The tube. Whatever it is bent to, its skin is its girth times the length of its axis, and so with what is inside
// (Pappus; the bends inside and outside make up for one another).
surface rail = sweep(
    circle((0, 0), tube / 2, normal = (1, 0, 0)),
    axis,
    tolerance = 0.01mm,
) with (color = "peru")
check area(rail) ~= pi * tube * length(axis) within 1e-5 * area(rail)
let steel = pi * (tube - wall) * wall * length(axis)
let full  = volume([rail, face(region(edge(rail, "v0"))), face(region(edge(rail, "v1")))])
check full ~= pi * tube^2 / 4 * length(axis) within 1e-5 * full
print "{length(axis):.0mm} of tube, {7.85 * steel / 1cm^3 / 1000:.1} kg; it climbs {climb:.2} at a radius of {1 / bent:.0mm}"
print "twisted by {twisted * 1m * 1rad:.1} to the metre, bent to {tightest:.0mm} at the ends"

// The treads, each from its edge to that of the next, and a post in the middle of each.
fn place(k, r) = polar(r, (k - 1) / (steps - 1) * turn) + (0, 0, floor(k) * riser)
fn tread(k) = {
    let [a, b] = [(k - 1) / (steps - 1) * turn, k / (steps - 1) * turn]
    fn around(r) = arc((0, 0, k * riser), r, a, b)
    let [inner, outer] = [around(150mm), around(radius + 50mm)]
    let border = [
        outer,
        line(outer.end, inner.end),
        reversed(inner),
        line(inner.start, outer.start),
    ]
    border |> region |> face
}
faces treads = [for k in 1..<steps: tread(k)] with (color = "silver")
curves posts = [for k in 1..<steps: line(place(k + 0.5, radius), helical((k - 0.5) / (steps - 1)))]
surfaces bars = [for p in posts: cylinder(p.start, 8mm, length(p))] with (color = "dimgray")
check every(
    1..steps,
    f = k => helical((k - 1) / (steps - 1)) ~= place(k, radius) + (0, 0, height) within 1e-3,
)

// For the bender: the axis, and places on it.
export axis to "handrail-axis.step"
export table([for at in [...range(0, length(axis) / 1mm, 250), length(axis) / 1mm]: {
    at: at * 1mm,
    place: axis(parameter_at_length(axis, at * 1mm)),
}]) to "handrail-axis.csv"
