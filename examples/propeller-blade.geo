// A propeller blade: sections of an ogival shape, wrapped onto cylinders about the shaft at the
// pitch of their radius, and skinned; with the hub and the other blades.
// x runs along the shaft, forward.

geo 1
unit mm
tolerance 1e-4mm

param diameter        = 1200mm in 100mm..10000mm "Diameter"
param pitch           = 1100mm in 100mm..20000mm "Advance of a turn"
param blades: integer = 4 in 2..7               "Number of blades"

// For each radius, as a part of the tip's: chord, thickness and skew back, as parts of the diameter.
let rows = [
    {r: 0.2, chord: 0.16, thick: 0.036, skew: 0},
    {r: 0.35, chord: 0.20, thick: 0.028, skew: -0.004},
    {r: 0.5, chord: 0.23, thick: 0.021, skew: -0.002},
    {r: 0.65, chord: 0.245, thick: 0.015, skew: 0.006},
    {r: 0.8, chord: 0.23, thick: 0.010, skew: 0.022},
    {r: 0.92, chord: 0.17, thick: 0.006, skew: 0.042},
    {r: 0.99, chord: 0.06, thick: 0.003, skew: 0.060},
]

// The outline of a section: s along the chord from the trailing edge over the back and home along
// the face, t across it.
fn outline(row, k) = {
    let angle = 15deg * k
    let s = 0.5 * row.chord * diameter * cos(angle) + row.skew * diameter
    let t = row.thick * diameter * (if k <= 12 then sin(angle)^2 else -0.12 * sin(angle)^2)
    [s, t]
}
// Wrapped: what runs along the chord climbs at the pitch angle and goes around the shaft.
fn wrapped(row, k) = {
    let radius = 0.5 * row.r * diameter
    let climb = atan(pitch / (tau * radius))
    let [s, t] = outline(row, k)
    let forward = s * sin(climb) + t * cos(climb)
    let turn = (s * cos(climb) - t * sin(climb)) / radius * 1rad
    (forward, radius * sin(turn), radius * cos(turn))
}
let sections = [for row in rows: interpolate([for k in 0..24: wrapped(row, k)])]
surface blade = skin(sections)

let told = report(blade)
print told.parameters, told.degree, told.control_points, told.least_weight
fn at(c, f) = c(c.domain.start + f * (c.domain.end - c.domain.start))
check every(
    0..6,
    k => every(
        linspace(0, 1, 25),
        f => norm(at(blade(_, told.parameters[k]), f) - at(sections[k], f)) < 1e-9mm,
    ),
) "every section lies in the blade"
check every(linspace(0.1, 0.9, 5), f => continuity(at_u(f)).c >= 2) "no section shows along the blade"
fn at_u(f) = blade(blade.domain_u.start + f * (blade.domain_u.end - blade.domain_u.start), _)
// The sections lie on their cylinders.
check every(
    0..6,
    k => every(
        0..24,
        i => hypot(wrapped(rows[k], i).y, wrapped(rows[k], i).z) ~= 0.5 * rows[k].r * diameter,
    ),
)

surface hub = cylinder((-0.08 * diameter, 0, 0), 0.11 * diameter, 0.16 * diameter, axis = (1, 0, 0))
surfaces all = [for k in 0 .. blades - 1: rotate(blade, 360deg / blades * k, axis = (1, 0, 0))]
print area(blade)
export [...all, hub] to "propeller-blade.obj"
