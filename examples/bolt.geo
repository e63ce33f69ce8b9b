// A hexagon bolt with its real thread: the profile of ISO 68-1 carried along a screw, united with shank and head
// to one closed mesh for a printer.
//
//     virote run bolt.geo
//     virote run bolt.geo --set size=8mm --set pitch=1.25mm --set flats=13mm --set head=5.3mm

geo 1
unit mm

param size   = 10mm in 3mm..30mm      "Diameter d of the thread"
param pitch  = 1.5mm in 0.5mm..3.5mm  "Pitch P"
param length = 40mm in 10mm..120mm    "Length below the head"
param thread = 26mm in 5mm..100mm     "Length of the thread"
param flats  = 16mm in 5mm..46mm      "Width of the head across flats"
param head   = 6.4mm in 2mm..20mm     "Height of the head"
param sides: integer = 36 in 12..120  "Straight pieces to a turn"

// The basic profile: a triangle of 60° and the height H, cut off by H/8 outside and by H/4 inside.
let triangle = sqrt(3) / 2 * pitch
let crest  = size / 2
let core   = crest - 5/8 * triangle
let middle = crest - 3/8 * triangle
let _core = assert(
    0.5 * pitch < core,
    "the pitch leaves no core: take a finer one, or a larger size",
)
let _head = assert(thread <= length - 2mm, "the thread is longer than the bolt: take less of it")
fn half_width(r) = pitch / 4 - (r - middle) * tan(30deg)
print "pitch diameter {2 * middle:.3mm}, core {2 * core:.3mm}, lead {atan(pitch / (2 * pi * middle)):.2}"
check half_width(crest) ~= pitch / 16 and half_width(core) ~= 3/8 * pitch       "P/8 and P/4 are flat"

// One ridge, from inside of the core to its crest and back, in the plane of r and z. Each corner goes along a
// helix; between those lie the flanks.
let deep = core - 0.1 * pitch
let corners = [
    (deep, -half_width(core)), (core, -half_width(core)), (crest, -half_width(crest)),
    (crest, half_width(crest)), (core, half_width(core)), (deep, half_width(core)),
]
region profile = region(polyline(corners, closed = true))
let turns = thread / pitch - 2
let start = length - thread + 1.5 * pitch
curves helices = [for p in corners: helix((0, 0, start + p.y), p.x, pitch, turns)]
surfaces flanks = [for i in 0..5: ruled(helices[i], helices[(i + 1) % 6])]

// The ridge as a mesh: a hexagon of corners at each step, joined to the next, and both ends.
let steps = ceil(turns * sides)
mesh ridge = mesh(
    flatten([for k in 0..steps: [for c in helices: c(k / steps)]]),
    [
        ...[
            for k in 0..<steps, i in 0..5:
            [for at in [i, i + 6, (i + 1) % 6 + 6, (i + 1) % 6]: 6 * k + at]
        ],
        [0, 1, 2, 3, 4, 5],
        [for i in 0..5: 6 * steps + 5 - i],
    ],
)
// What is carried along a screw sweeps the way of its centre about the axis times its area; pieces of a turn
// stay inside of that by the part that a polygon lies inside of its circle.
let swept = 2 * pi * turns * area(profile) * centroid(profile).x
let part  = sin(360deg * turns / steps) / (2 * pi * turns / steps)
check volume(ridge) ~= part * swept within 0.005 * swept
check angle_between(corners[2] - corners[1], corners[3] - corners[4]) ~= 60deg

// The shank with the core of the thread, both ends chamfered; the head, a prism whose corners a cone takes off.
surface shank = revolve(polyline(
    (0, 0, -0.5 * head), (crest, 0, -0.5 * head), (crest, 0, length - thread),
    (core, 0, length - thread + 0.6 * pitch), (core, 0, length - 0.5 * pitch),
    (core - 0.5 * pitch, 0, length), (0, 0, length),
))
let wide = flats / sqrt(3)
let bearing = 0.475 * flats
surface cone = revolve(polyline(
    (0, 0, -head), (bearing, 0, -head), (wide + 1, 0, (wide + 1 - bearing) * tan(30deg) - head),
    (wide + 1, 0, 0), (0, 0, 0),
))
curve below = polyline([for k in 0..5: polar(wide, k * 60deg) - (0, 0, head + 1)], closed = true)
curve above = translate(below, (0, 0, head + 2))
let prism = [ruled(below, above), flip(face(region(below))), face(region(above))]
fn meshed(g) = tessellate(g, tolerance = 0.02mm)
mesh bolt = union(ridge, meshed(shank), intersection(meshed(prism), meshed(cone)))
let told = check_mesh(bolt)
check told.closed and told.manifold and told.oriented and told.components == 1 and told.euler == 2 "one body"
print bolt, "it weighs {volume(bolt) / 1cm^3 * 7.85:.1} g of steel"

// What the bolt bears: the stress area between pitch diameter and the rounded root, ISO 898-1, which for M10 is
// told as 58 mm².
let stress = pi / 4 * (middle + core - triangle / 12)^2
print stress
check stress ~= pi / 4 * (size - 0.9382 * pitch)^2 within 1e-4 * stress
export bolt to "bolt.stl"
