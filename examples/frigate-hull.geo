// The hull of a small ship from its lines: frames across, waterlines and the sheer along, both
// through one table of offsets. The surface runs through all of them.
// x runs forward from the transom, y to port, z upward from the keel.

geo 1
unit m
tolerance 1e-6

// Half breadths in metres: a row for each waterline from the keel up, a column for each frame.
let stations = [0, 3, 7, 12, 17, 21, 24]
let heights  = [0, 0.6, 1.4, 2.4, 3.6]
let offsets  = [
    [0.10, 0.15, 0.20, 0.22, 0.18, 0.10, 0.04],
    [1.05, 1.62, 2.02, 2.10, 1.55, 0.72, 0.10],
    [1.80, 2.45, 2.86, 2.92, 2.35, 1.22, 0.22],
    [2.30, 2.90, 3.22, 3.27, 2.85, 1.74, 0.45],
    [2.62, 3.15, 3.40, 3.45, 3.18, 2.28, 0.85],
]
// The bow rakes forward, the transom aft, and the sheer rises to both ends.
fn place(j, k) = (
    stations[j] + 0.35 * heights[k] * (stations[j] / 24) -
        0.1 * heights[k] * (1 - stations[j] / 24),
    offsets[k][j],
    heights[k] * (1 + 0.0009 * (stations[j] - 11)^2),
)

curves waterlines = [for k in 0..4: interpolate([for j in 0..6: place(j, k)])]
curves frames     = [for j in 0..6: interpolate([for k in 0..4: place(j, k)])]
surface port      = gordon(u = waterlines, v = frames)

// Every line lies in the surface within the tolerance, and says how far at most.
let made = report(port)
print made.deviation, made.gap, made.degree, made.control_points
check made.deviation <= 1e-6 "the lines lie in the surface"
check every(
    frames,
    f => every(
        linspace(f.domain.start, f.domain.end, 21),
        t => closest(port, f(t)).distance <= 1e-6,
    ),
)
check every(
    waterlines,
    w => every(
        linspace(w.domain.start, w.domain.end, 21),
        t => closest(port, w(t)).distance <= 1e-6,
    ),
)

// It bends without a break: the inner knots stand once each in a cubic.
print continuity(waterlines[2]).c, continuity(frames[3]).c
let curve_between = port(_, 0.5 * (port.domain_v.start + port.domain_v.end))
check continuity(curve_between).c >= 2 "no frame shows in a waterline between those drawn"

surface starboard = mirror(port, plane((0, 0, 0), (0, 1, 0)))
print length(waterlines[4]), area(port)

export [port, starboard] to "frigate-hull.obj"
