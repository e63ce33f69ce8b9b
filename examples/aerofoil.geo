// An aerofoil from measured points: one smooth curve of few control points, and what it promises.
//
//     virote run aerofoil.geo
//     virote run aerofoil.geo --set allowed=0.1mm     nearer to the points, more control points
//
// The points are those of the NACA 0012, for which there is a formula to compare with: Jacobs, Ward & Pinkerton,
// NACA Report 460 (1933). They are rounded to four digits, as a table or a measuring machine gives them.

geo 1
unit m

param allowed = 0.5mm in 0.1mm..5mm    "How far the curve may pass from a point"

fn half_thickness(x) =
    0.6 * (0.2969 * sqrt(x) - 0.1260 * x - 0.3516 * x^2 + 0.2843 * x^3 - 0.1036 * x^4)

fn rounded(x) = round(x * 10000) / 10000

// From the trailing edge over the upper side to the nose, and back below.
let stations = cosspace(0, 1, 35)
let upper = [for x in stations: (rounded(x), rounded(half_thickness(x)))]
let lower = [for q in upper: (q.x, -q.y)]
let measured = [...reverse(upper), ...lower[1..-1]]

// Through every point: follows the rounding of the table.
curve through = interpolate(measured, parameters = "centripetal")
// Near every point: as few control points as keep the tolerance.
curve foil = approximate(measured, tolerance = allowed)

print len(measured), len(through.points), len(foil.points)
check len(foil.points) <= 15                              "a quarter of the points carries the outline"
check foil.start ~= (1, 0) and foil.end ~= (1, 0)         "the trailing edge is closed and where it was measured"

/// The distance of q from the segment from a to b.
fn to_segment(q, a, b) = {
    let along = clamp(dot(q - a, b - a) / dot(b - a, b - a), 0, 1)
    distance(q, a + along * (b - a))
}

// A polygon of the curve, finer than anything that is measured here.
let polygon = [for t in linspace(0, 1, 1001): foil(t)]
fn to_foil(q) = min([for i in 0..<1000: to_segment(q, polygon[i], polygon[i + 1])])
check max([for q in measured: to_foil(q)]) <= allowed / 1m + 2e-6    "every point is within the tolerance"

// Between the points too the curve is the aerofoil.
let between = linspace(0.02, 0.98, 25)
check max([for x in between: to_foil((x, half_thickness(x)))]) <= 1.5 * (allowed / 1m)    "no waves between the points"

// The nose is round.
let front = min([for q in polygon: q.x])
check front ~= 0 within allowed / 1m                    "the nose is where it was measured"

export foil to "aerofoil.obj"
export table([for q in measured: {x: q.x, y: q.y, distance: to_foil(q)}]) to "aerofoil.csv"
