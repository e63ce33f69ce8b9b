// The hull of Wigley, a standard of ship hydrodynamics: parabolas in every waterline and every
// frame. It is one Bézier patch of degree 2 in both directions, without any approximation, so
// that whatever is measured on it has a closed form.
// x runs forward from amidships, y to port, z upward from the still water.

geo 1
unit m

param length  = 100m in 20m..300m "Length L in the waterline"
param beam    = 10m in 2m..40m    "Breadth B in the waterline"
param draught = 6.25m in 1m..20m  "Draught T"

// y = B/2 (1 − (2x/L)²) (1 − (z/T)²), in Bernstein form: the first bracket has the coefficients
// 0, 2, 0 from stern to bow, the second 0, 1, 1 from the keel to the water.
let waterline = [0, 2, 0]
let frame     = [0, 1, 1]
surface port = bezier([for i in 0..2: [for j in 0..2: (
    (i - 1) * length / 2,
    beam / 2 * waterline[i] * frame[j],
    (j - 2) * draught / 2,
)]])

fn breadth(x, z) = beam / 2 * (1 - (2 * x / length)^2) * (1 - (z / draught)^2)
let places = linspace(0, 1, 9)
check every(places, u => every(places, v => {
    let p = port(u, v)
    p.y ~= breadth(p.x, p.z)
}))

surface starboard = mirror(port, plane((0, 0, 0), (0, 1, 0)))
surface deck      = ruled(edge(port, "v1"), edge(starboard, "v1"))

// Displacement: the volume below the water.
let displacement = volume([port, starboard, deck])
print displacement
check displacement / (length * beam * draught) ~= 4 / 9 "the block coefficient"

// The centre of buoyancy lies amidships, three eighths of the draught below the water.
let buoyancy = centroid([port, starboard, deck])
print buoyancy.z
check buoyancy ~= (0, 0, -3 / 8 * draught)

// Areas of the waterplane and of the midship section.
let waterplane = area(deck)
curve midship = port(0.5, _)
surface section_amidships = ruled(midship, mirror(midship, plane((0, 0, 0), (0, 1, 0))))
print waterplane, area(section_amidships)
check waterplane ~= 2 / 3 * length * beam
check area(section_amidships) ~= 2 / 3 * beam * draught

// The metacentre stands above the centre of buoyancy by the waterplane's second moment about its
// long axis over the displacement.
let moment = inertia(deck, of = "area").tensor[0][0]
let metacentric_radius = moment / displacement
print metacentric_radius
check moment ~= 4 / 105 * length * beam^3 "the cube of a parabola, integrated"
check metacentric_radius ~= 3 / 35 * beam^2 / draught

// The wetted surface has no closed form; it is a little more than twice the lateral plane.
let wetted = 2 * area(port)
print wetted
check wetted > 2 * length * draught

// Waterlines and frames are curves of the hull, exactly.
curves lines = [for v in [0.25, 0.5, 0.75, 1]: port(_, v)]
curves frames = [for u in linspace(0.1, 0.9, 9): port(u, _)]
check every(frames, f => f.degree == 2 and is_planar(f))

export [port, starboard] to "wigley-hull.obj"
