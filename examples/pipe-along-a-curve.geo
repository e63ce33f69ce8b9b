// A pipe along a curve in space, a coil along a closed one, and a gutter around corners.

geo 1
unit mm
tolerance 1e-6

let ring = circle((0, 0, 0), 8, normal = (1, 0, 0))

// The axis passes through points in space; the section is carried along without turning about it.
curve axis   = interpolate([
    (0, 0, 0),
    (60, 10, 20),
    (90, 60, 60),
    (60, 110, 80),
    (0, 120, 120),
    (-40, 80, 160),
    (-30, 20, 200),
])
surface pipe = sweep(ring, axis)

let made = report(pipe)
print made.deviation, made.degree, made.control_points, made.folds
let places = linspace(axis.domain.start, axis.domain.end, 121)
let radii  = [
    for u in linspace(0, 1, 9): max([for v in places: abs(norm(pipe(u, v) - axis(v)) - 8)])
]
print max(radii)
check max(radii) <= 1e-6 "every point of the pipe is 8 mm from the axis"
print continuity(pipe).g, continuity(pipe).curvature_gap
check continuity(pipe).g >= 1 "the pipe bends without a break"

// Around a closed axis the section comes back as it left: the angle by which it would miss itself
// is spread over the length.
curve knot = interpolate(
    [
        for k in 0..47:
            (
                (60 + 25 * cos(22.5deg * k)) * cos(15deg * k),
                (60 + 25 * cos(22.5deg * k)) * sin(15deg * k),
                25 * sin(22.5deg * k),
            )
    ],
    closed = true,
)
surface tube = sweep(ring, knot)
print report(tube).closing_angle, report(tube).deviation
check every(
    linspace(0, 1, 9),
    u => norm(tube(u, knot.domain.start) - tube(u, knot.domain.end)) < 1e-12,
)
print continuity(tube).angle
check continuity(tube).angle < 0.001deg "nor does the seam show"
