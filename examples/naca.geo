// A NACA four-digit aerofoil from its formula, as a curve, a wing and a table.
//
//     virote run naca.geo
//     virote run naca.geo --set camber=0 --set thickness=18      the NACA 0018
//
// Jacobs, Ward & Pinkerton, NACA Report 460 (1933). The default is the NACA 2412.

geo 1
unit mm

param camber: integer    = 2 in 0..9      "First digit: largest camber, hundredths of the chord"
param position: integer  = 4 in 1..9      "Second digit: where it is, tenths of the chord"
param thickness: integer = 12 in 1..40    "Last digits: largest thickness, hundredths of the chord"
param chord              = 200mm in 10mm..5m
param trailing_edge      = "closed" in ["closed", "open"]
param stations: integer  = 61 in 11..501  "Points on each side"

// Everything is computed for a chord of 1 and scaled at the end.
let m = camber / 100
let p = position / 10
let t = thickness / 100

/// Half of the thickness at x. The last coefficient decides whether the trailing edge closes.
let last_coefficient = if trailing_edge == "closed" then 0.1036 else 0.1015
fn half_thickness(x) =
    5 * t * (0.2969 * sqrt(x) - 0.1260 * x - 0.3516 * x^2 + 0.2843 * x^3 - last_coefficient * x^4)

/// The camber line: two parabolas that meet at its highest point.
fn camber_line(x) =
    if x < p then m / p^2 * (2 * p * x - x^2)
    else m / (1 - p)^2 * (1 - 2 * p + 2 * p * x - x^2)

/// Its slope.
fn camber_slope(x) = if x < p then 2 * m / p^2 * (p - x) else 2 * m / (1 - p)^2 * (p - x)

/// The point at x on one side: the thickness stands at right angles to the camber line.
fn surface_point(x, side) = {
    let slope = atan(camber_slope(x))
    let half = side * half_thickness(x)
    (x - half * sin(slope), camber_line(x) + half * cos(slope))
}

// Stations are denser towards both ends, where the outline bends. It runs from the trailing edge
// over the upper side to the nose, and back below.
let positions = cosspace(0, 1, stations)
let upper = [for s in positions: surface_point(s, 1)]
let lower = [for s in positions: surface_point(s, -1)]
let outline = [...reverse(upper), ...lower[1..-1]]

curve foil = polyline([for q in outline: q * chord])
// The same points as control points of a cubic: smooth, and inside the polygon by a hair.
curve smooth_foil = clamped([for q in outline: q * chord])

// The leading edge is at the origin, the trailing edge at the end of the chord.
check outline[stations - 1] ~= (0, 0) within 1e-15
check foil(stations - 1) ~= (0, 0)                                "the leading edge is at the origin"
check abs(foil.start.x - chord) < 0.002 * chord                   "the chord is as long as it was asked to be"

let gap = norm(first(outline) - last(outline))
print gap
check (trailing_edge == "closed" and gap < 1e-4)
    or (trailing_edge == "open" and gap ~= 0.021 * t within 1e-6)
    "the trailing edge is closed, or as thick as the formula says"

// The thickness is largest at three tenths of the chord, to the digits of the coefficients.
let fine = linspace(0, 1, 1001)
let greatest = max([for s in fine: 2 * half_thickness(s)])
print greatest
check greatest ~= t within 1e-3 * t                               "the greatest thickness is that of the digits"
check 2 * half_thickness(0.3) ~= greatest within 1e-4 * t         "it is at 0.3 of the chord"

// The camber line is exact as two Bézier parabolas. Their derivatives confirm the slope.
curve front = bezier((0, 0), (p / 2, m), (p, m))
curve rear = bezier((p, m), ((1 + p) / 2, m), (1, 0))
fn slope_of(c, s) = derivative(c, s).y / derivative(c, s).x
let fractions = linspace(0, 1, 11)[1..-2]
check [for s in fractions: front(s).y] ~= [for s in fractions: camber_line(front(s).x)] within 1e-15
check [for s in fractions: rear(s).y] ~= [for s in fractions: camber_line(rear(s).x)] within 1e-15
check [for s in fractions: slope_of(front, s)]
    ~= [for s in fractions: camber_slope(front(s).x)] within 1e-14
check [for s in fractions: slope_of(rear, s)]
    ~= [for s in fractions: camber_slope(rear(s).x)] within 1e-14
check camber_slope(0) ~= 2 * m / p and camber_slope(1) ~= -2 * m / (1 - p)    "closed forms at the ends"

// A wing that tapers: straight lines from the root to a smaller and twisted tip.
let span = 4 * chord
curve tip = translate(rotate(scale(foil, 0.5), -3deg), (0.3 * chord, 0, span))
surface wing = ruled(foil, tip)
check wing(stations - 1, 1) ~= (0.3 * chord, 0, span)             "the leading edge is straight"

mesh wing_mesh = grid_mesh(wing, 2 * stations - 2, 4)
print wing_mesh

export table([for s in positions: {
    x: s * chord,
    upper: surface_point(s, 1) * chord,
    lower: surface_point(s, -1) * chord,
    camber: camber_line(s) * chord,
    thickness: 2 * half_thickness(s) * chord,
}]) to "naca.csv"
export foil, smooth_foil to "naca.obj"
export wing_mesh to "naca-wing.obj"
