// A wing through a body: each is trimmed where the other begins, along one curve that lies on both.
// x runs aft, y outboard, z up.

geo 1
unit m

param span = 6m in 3m..12m        "How far out the tip is"
param dihedral = 4deg in -5deg..10deg "How much the wing rises"

// The body: a curve from the nose to the tail, turned about the x axis.
curve contour = bspline(
    [(-4, 0, 0), (-4, 0, 0.9), (-1, 0, 1.3), (3, 0, 1.1), (6, 0, 0.5), (8, 0, 0.05)],
    degree = 3,
)
surface body = revolve(contour, axis = (1, 0, 0))

// The wing: one half, whose root lies inside of the body; a sharp trailing edge.
fn half(x) = 0.6 * (0.2969 * sqrt(x) - 0.126 * x - 0.3516 * x^2 + 0.2843 * x^3 - 0.1036 * x^4)
fn station(k) = 0.5 + 0.5 * cos(12deg * k)
let profile = interpolate([
    for k in 0..30: (station(k), 0, (if k <= 15 then 1 else -1) * half(station(k)))
])
fn section(y, chord, aft) = profile |> scale(chord) |> translate((aft, y, y * tan(dihedral)))
surface wing = skin([section(0, 2.4, 0), section(0.5 * span, 1.7, 0.6), section(span, 0.9, 1.3)])

face outer = trim(wing, by = body, keep = wing(0.5, 0.9)) with (color = "lightgray")
face skin_of_body = trim(body, by = wing, keep = contour(0.1)) with (color = "steelblue")
face root_hole = trim(body, by = wing, keep = closest(body, (1, 1.2, 0)).point)

// The curve of both: on the wing and on the body within the tolerance.
let root = filter(
    edges(outer),
    e => norm(e(e.domain.start) - closest(body, e(e.domain.start)).point) < 1e-5,
)
curves joint = root with (color = "red")
check every(
    root,
    e => every(
        linspace(e.domain.start, e.domain.end, 9),
        t => closest(body, e(t)).distance <= 1e-6,
    ),
)
print sum([for e in root: length(e)]), sum([for e in edges(root_hole): length(e)])
check sum([for e in root: length(e)]) ~= sum([for e in edges(root_hole): length(e)]) within 1e-5

// What is wetted: the wing outside, the body but for the hole.
print area(wing), area(outer), area(root_hole)
check area(skin_of_body) + area(root_hole) ~= area(body) within 1e-9
check area(outer) < area(wing)

export outer, skin_of_body to "wing-root.step"
