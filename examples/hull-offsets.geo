// A hull from its table of offsets: half-breadths by stations and waterlines, as the mould loft has them, and
// its hydrostatics at many draughts as one table. x runs forward from amidships, z upward from the keel.

geo 1
unit m

let offsets = load("hull-offsets.csv")
let heights = [0m, 0.14m, 0.28m, 0.56m, 1.12m, 1.68m, 2.8m, 4.2m, 5.6m]
let stations = 0..<len(offsets)

// A surface through all points. Its parameters are x and z themselves, so that frames and waterlines are
// lines of one parameter, exactly.
surface port = interpolate(
    [for i in stations: [for z in heights: (offsets.x[i], offsets["{z}"][i], z)]],
    parameters = {u: [for x in offsets.x: x / 1m], v: [for z in heights: z / 1m]},
) with (color = "lightsteelblue")
surface starboard = mirror(port, ZX) with (color = "lightsteelblue")
curves frames = [for x in offsets.x: port(x / 1m, _)] with (color = "firebrick")
curves waterlines = [for z in heights: port(_, z / 1m)] with (color = "seagreen")
check every(stations, f = i => every(heights, f = z =>
    port(offsets.x[i] / 1m, z / 1m) ~= (offsets.x[i], offsets["{z}"][i], z)))   "it goes through the offsets"

// What is below a waterline: both sides, and the waterplane between them. Centres are told by their distance
// from amidships and above the keel, the metacentre stands over the centre of buoyancy by the second moment of
// the waterplane over the displacement.
fn hydrostatics(draught) = {
    let side  = trim(port, v = 0 .. draught / 1m)
    let line  = edge(side, "v1")
    let plane = region([line, reversed(mirror(line, ZX))])
    let shell = [side, mirror(side, ZX), face(plane)]
    let displacement = volume(shell)
    let buoyancy = centroid(shell)
    {
        draught,
        displacement,
        lcb: buoyancy.x,
        kb: buoyancy.z,
        waterplane: area(plane),
        lcf: centroid(plane).x,
        km: buoyancy.z + inertia(plane).tensor[0][0] / displacement,
        wetted: 2 * area(side),
    }
}
table form = table([for d in [1m, 2m, 3m, 4m, 5m, 5.6m]: hydrostatics(d)])
table sheet = table([for i in 0..<len(form): {
    draught: form.draught[i],
    displacement: round(form.displacement[i], 1),
    lcb: round(form.lcb[i], 3),
    kb: round(form.kb[i], 3),
    km: round(form.km[i], 3),
    waterplane: round(form.waterplane[i], 1),
    lcf: round(form.lcf[i], 3),
    wetted: round(form.wetted[i], 1),
}])
print sheet

// The offsets are those of y = B/2 (1 - ξ⁴) (1 + a ξ) (1 - ζ⁶) with ξ = 2x/L and ζ = 1 - z/T, rounded to a
// millimetre, so that the right answers are known; the spline adds what it swings between the points.
let [length, beam, depth, a] = [90m, 14m, 5.6m, 0.08]
fn breadth(x, z) = beam / 2 * (1 - (2*x/length)^4) * (1 + a * 2*x/length) * (1 - (1 - z/depth)^6)
let full = last([for i in 0..<len(form): form[i]])
check full.displacement / (length * beam * depth) ~= 24/35 within 0.001       "the block coefficient"
check full.waterplane ~= 4/5 * length * beam within 0.001 * length * beam
check full.lcb ~= 5/21 * a * length / 2 within 0.002
check full.kb ~= 9/16 * depth within 0.002
let moment = 2/3 * integrate(x => breadth(x, depth)^3, -length / 2 .. length / 2)
check full.km - full.kb ~= moment / (24/35 * length * beam * depth) within 0.01
check every(0..<len(form), f = i => {
    let slices =
        2 * integrate((x, z) => breadth(x, z), [-length / 2 .. length / 2, 0m..form.draught[i]])
    form.displacement[i] ~= slices within 0.005 * slices
}) "half a per cent at the lowest draught, less above"

export sheet to "hull-offsets-hydrostatics.csv"
export port, starboard to "hull-offsets.step"
