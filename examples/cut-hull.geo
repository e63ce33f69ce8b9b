// A hull that goes on above the water, cut at it: displacement, waterplane, centre of buoyancy and metacentre of
// what is below, upright and heeled. The underwater part is Wigley's, so that each number has a closed form.
// x runs forward from amidships, y to port, z upward from the still water.

geo 1
unit m

param length    = 100m in 20m..300m "Length L in the waterline"
param beam      = 10m in 2m..40m    "Breadth B in the waterline"
param draught   = 6.25m in 1m..20m  "Draught T"
param freeboard = 4m in 1m..20m     "Height of the deck over the water"
param heel      = 5deg in 0deg..8deg "Heel of the second cut"

// Below the water y = B/2 (1 − (2x/L)²) (1 − (z/T)²); above it the sides stand upright. Two Bézier patches a
// side, joined to one surface whose knot is the waterline.
let waterline = [0, 2, 0]
fn side(heights, breadths) = bezier([for i in 0..2: [for j in 0..2: (
    (i - 1) * length / 2,
    beam / 2 * waterline[i] * breadths[j],
    heights[j],
)]])
surface port = join([[
    side([-draught, -draught / 2, 0], [0, 1, 1]),
    side([0, freeboard / 2, freeboard], [1, 1, 1]),
]])
surface starboard = mirror(port, plane((0, 0, 0), (0, 1, 0)))

// What is below a plane: both sides, and the waterplane within the edges that the cut has made.
fn below(water) = {
    let sides = [for s in [port, starboard]: trim(s, by = water, keep = "below")]
    let on_water = f => filter(
        edges(f),
        e => every(
            [0.1, 0.5, 0.9],
            t => dot(e(lerp(e.domain.start, e.domain.end, t)) - water.origin, water.z) ~= 0,
        ),
    )
    let lid = face(region([...on_water(sides[0]), ...[for e in on_water(sides[1]): reversed(e)]]))
    {sides, lid, all: [...sides, lid]}
}

let upright = below(XY)
let displacement = volume(upright.all)
print displacement, area(upright.lid), centroid(upright.all)
check displacement ~= 4 / 9 * length * beam * draught within 1e-3 "the block coefficient is 4/9"
check area(upright.lid) ~= 2 / 3 * length * beam within 1e-4
check centroid(upright.all) ~= (0, 0, -3 / 8 * draught) within 1e-4

// The metacentre above the centre of buoyancy: the waterplane's second moment over the displacement.
let moment = inertia(upright.lid).tensor[0][0]
let radius = moment / displacement
print radius
check radius ~= 3 / 35 * beam^2 / draught within 1e-4

// Heeled about the x axis, the centre of buoyancy moves out by nearly the metacentric radius times the angle.
let water  = rotate(plane((0, 0, 0), (0, 0, 1)), heel, axis = (1, 0, 0))
let heeled = below(water)
let shift  = dot(centroid(heeled.all) - centroid(upright.all), water.y)
let lever  = shift / sin(max(heel, 0.01deg))
print volume(heeled.all), shift
check volume(heeled.all) ~= displacement within 1e-3 * displacement "a wedge goes in where one comes out"
check lever ~= radius within 0.02 * radius

// The wetted surface, and the hull in halves for a look.
print sum([for s in upright.sides: area(s)])
faces wetted = heeled.sides with (color = "steelblue")
face waterplane = heeled.lid with (color = "lightblue")
faces dry = [
    for s in [port, starboard]: trim(s, by = water, keep = "above")
] with (color = "lightgray")
export wetted, waterplane, dry to "cut-hull.step"
