// A wing with twist, taper and sweep through its profiles, and the nacelle under it from a network
// that closes around.
// x runs aft, y outboard, z up.

geo 1
unit m
tolerance 1e-6

// The NACA 0012 for a chord of 1 with its trailing edge closed: along the top to the nose, and back.
fn half(x) = 0.6 * (0.2969 * sqrt(x) - 0.126 * x - 0.3516 * x^2 + 0.2843 * x^3 - 0.1036 * x^4)
fn station(k) = 0.5 + 0.5 * cos(9deg * k)
let profile = interpolate([
    for k in 0..40: (station(k), 0, (if k <= 20 then 1 else -1) * half(station(k)))
])

// How far out, how far aft, how high; chord, and incidence, which washes out.
let stations = [
    {place: (0, 0, 0), chord: 3.2, angle: 3deg},
    {place: (0.8, 2, 0.12), chord: 2.6, angle: 2.4deg},
    {place: (2, 5, 0.35), chord: 1.8, angle: 1.2deg},
    {place: (3.2, 8, 0.65), chord: 1.2, angle: -0.5deg},
    {place: (4, 10, 0.9), chord: 0.8, angle: -2deg},
]
fn section(s) = profile |> scale(s.chord) |> rotate(s.angle, axis = (0, 1, 0)) |> translate(s.place)
let sections = [for s in stations: section(s)]
surface wing = skin(sections)

let told = report(wing)
print told.parameters, told.degree, told.control_points
let places = linspace(0, 1, 33)
fn at(c, f) = c(c.domain.start + f * (c.domain.end - c.domain.start))
check every(
    0..4,
    k => every(places, f => norm(at(wing(_, told.parameters[k]), f) - at(sections[k], f)) < 1e-12),
) "every profile lies in the wing"
check every(linspace(0.05, 0.95, 7), f => continuity(wing(f, _)).c >= 2) "no profile shows along the span"

// The nacelle: rings around it and lines along it, through one table of radii; a little flat
// below. No ring has the parameters of another.
let along = [0, 0.25, 0.8, 1.6, 2.6, 3.4]
let radii = [0.52, 0.66, 0.76, 0.74, 0.58, 0.38]
fn rim(k, j) = {
    let angle = 45deg * j
    let flat = if sin(angle) < 0 then 1 - 0.12 * sin(angle)^2 else 1
    (
        along[k] - 0.6,
        3 + radii[k] * cos(angle) * (1 + 0.03 * k),
        radii[k] * flat * sin(angle) - 0.75,
    )
}
curves rings = [for k in 0..5: interpolate([for j in 0..7: rim(k, j)], closed = true)]
curves lines = [for j in 0..7: interpolate([for k in 0..5: rim(k, j)])]
surface nacelle = gordon(u = rings, v = lines)

let made = report(nacelle)
print made.deviation, made.seam_u, made.degree, made.control_points
print [for line in made.v: line.reparametrized]
check made.deviation <= 1e-6 "rings and lines lie in the nacelle"
check made.seam_u < 0.01deg "the seam cannot be seen"
check every(rings, c => every(places, f => closest(nacelle, at(c, f)).distance <= 1e-6))
check every(lines, c => every(places, f => closest(nacelle, at(c, f)).distance <= 1e-6))
print continuity(nacelle).g, continuity(nacelle).angle
check continuity(nacelle).g >= 1

export [wing, nacelle] to "wing-and-nacelle.obj"
