// A hull of Wigley's family, y = ±B/2 (1 - (2x/L)^2) (1 - (z/T)^2), and what resists it in calm water.
//
// Friction: the line of the ITTC of 1957. Waves: Michell's integral for thin ships (Philosophical Magazine 45,
// 1898), whose inner integrals have a closed form for this hull.

geo 1
unit m

param length  = 100m in 60m..140m  "Length of the waterline"
param beam    = 10m in 6m..18m     "Beam"
param draught = 6.25m in 4m..9m    "Draught"
param speed   = 9.4 in 4..14       "Speed in metres a second"

// The side is exact: a product of two parabolas is a Bézier surface of degree 2.
let half = beam / 2
let across = [0, 2 * half, 0]
let down = [1, 1, 0]
surface side = bezier([for i in 0..2:
    [for j in 0..2: (-length / 2 + i * length / 2, across[i] * down[j], -j * draught / 2)]])
surface other = mirror(side, ZX)
surface deck = ruled(edge(side, "v0"), edge(other, "v0"))

let displacement = volume([side, other, deck])
let wetted = 2 * area(side)
check displacement ~= 4 / 9 * length * beam * draught within 1e-6 * (1m)^3 "Wigley's displacement"

// From here on plain numbers in metres, seconds and newtons: sea water at 15 degrees.
let density = 1026
let viscosity = 1.19e-6
let gravity = 9.81
let [l, b, t, s] = [length / 1m, beam / 1m, draught / 1m, wetted / (1m)^2]
let froude = speed / sqrt(gravity * l)
let reynolds = speed * l / viscosity
let friction_coefficient = 0.075 / (log10(reynolds) - 2)^2
let dynamic = 0.5 * density * s * speed^2
let friction = friction_coefficient * dynamic

let k = gravity / speed^2
fn along(a) = -4 * b / l^2 * 2 * (sin(a * l / 2) / a^2 - l / 2 * cos(a * l / 2) / a)
fn below(d) = {
    let e = exp(-d * t)
    (1 - e) / d - (2 / d^3 - e * (t^2 / d + 2 * t / d^2 + 2 / d^3)) / t^2
}
// With lambda = cosh(r) the integrand has no pole; beyond r = 3 nothing is left of it.
fn integrand(r) = (along(k * cosh(r)) * below(k * cosh(r)^2) * cosh(r))^2
let waves = 4 * density * gravity^2 / (pi * speed^2) * integrate(integrand, 0..3)
let wave_coefficient = waves / dynamic

let resistance = friction + waves
// What it takes to move a tonne: newtons a tonne.
let burden = resistance / (density / 1000 * displacement / (1m)^3)
check froude < 0.42 "the formula is for hulls that do not plane"
print froude, friction_coefficient, wave_coefficient, resistance
