// A bottle for half a litre: the radius of its body is solved for what goes in to the brim, and the
// height of the filling line for what is sold. Around that the glass has an even thickness.
//
//     virote run bottle-volume.geo
//     virote run bottle-volume.geo --set height=260mm --set contents=750

geo 1
unit mm

param contents = 500 in 200..1000          "What is sold, in millilitres"
param headroom = 4 in 2..10                "Room above the filling line, per cent of the contents"
param height   = 220mm in 160mm..320mm     "Height inside"
param neck     = 9mm in 7mm..14mm          "Radius of the neck inside"
param glass    = 3mm in 1.5mm..6mm         "Thickness of the glass"

let sold    = contents * 1cm^3
let brimful = sold * (1 + headroom / 100)

// The outline of the cavity in the xz-plane, from the foot upward: a body, a shoulder, a neck.
// Where four control points stand one above the other the cubic is straight.
fn outline(body) = clamped([
    (0, 0, 0),
    (0.75 * body, 0, 0),
    (body, 0, 0.02 * height),
    (body, 0, 0.15 * height),
    (body, 0, 0.35 * height),
    (body, 0, 0.55 * height),
    (neck, 0, 0.68 * height),
    (neck, 0, 0.80 * height),
    (neck, 0, 0.90 * height),
    (neck, 0, height),
])

// What a profile holds that begins on the axis: it is turned, and a disc closes it on top.
fn held(profile) = volume([
    revolve(profile),
    disc(plane((0, 0, profile.end.z), (0, 0, 1)), profile.end.x),
])

let body = solve(r => held(outline(r)) - brimful, within = neck..90mm)
curve profile = outline(body)

// The filling line: the same of a part of the profile.
let filled_to = solve(t => held(trim(profile, 0..t)) - sold, within = 0.5..profile.domain.end)
point mark = profile(filled_to)
print "the body has a diameter of {2 * body + 2 * glass:.2mm}, the liquid stands {mark.z:.2} mm high"

// By slices, V = π ∫ r² dz, whatever the surface says.
fn slices(t) = pi * integrate(s => profile(s).x^2 * derivative(profile, s).z, 0..t) * 1mm^3
check slices(profile.domain.end) ~= brimful within 1e-6 * brimful
check slices(filled_to) ~= sold within 1e-6 * sold

// The glass lies between the cavity and an outline at one distance; a ring closes both at the mouth.
curve outside = offset(profile, glass, normal = (0, -1, 0))
curve lip     = line(outside.end, profile.end)
let of_glass  = volume([revolve(outside), revolve(profile), revolve(lip)])
print "the glass weighs {2.5 * of_glass / 1cm^3:.1} g at 2.5 g/cm³"

// Steiner's formula: a skin of thickness g over an area A has the volume g A + g² M + g³/3 K. Of a surface
// of revolution M, the integral of the mean curvature, is π (height + ∫ κ r ds) with the curvature κ of the
// profile, and K, of the Gaussian curvature, is 2π from a level foot to an upright neck.
let bend = integrate(
    t => signed_curvature(profile, t, normal = (0, -1, 0)) * profile(t).x *
        norm(derivative(profile, t)),
    profile.domain,
)
let skin = area(revolve(profile)) * glass + pi * (height + bend) * glass^2 + 2 * pi / 3 * glass^3
check of_glass ~= skin within 1e-6 * skin

// For the mould: the section through the glass, and the cavity. For the eye: half of a turn, with what it holds.
region glass_section = region([outside, lip, reversed(profile), line(profile.start, outside.start)])
surfaces walls = [
    for c in [outside, profile, lip]: revolve(c, angle = 180deg)
] with (color = "#7aa6a1")
surface liquid = revolve(line((0, 0, mark.z), mark), angle = 180deg) with (color = "#c98a2b")
export glass_section to "bottle-volume.dxf"
export revolve(profile) to "bottle-volume.step"
