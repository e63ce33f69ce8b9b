// Areas of plane sections whose borders are no conics, and volumes of what is cut there, against integrals and closed forms.
geo 1
unit m

let ring = solid(torus((0, 0), 3, 1))
fn upright(x) = plane((x, 0), (1, 0, 0))
fn total(regions) = sum([for r in regions: area(r)]) / 1m^2
fn volume_of(s) = volume(s) / 1m^3

// Spiric sections, at a distance from the axis: y = sqrt(rho^2 - x^2) at the radii 3 + cos t and 3 - cos t.
fn reach(rho, x) = sqrt(rho^2 - x^2)
fn spiric(x) = integrate(t => 2 * (reach(3 + cos(t), x) - reach(3 - cos(t), x)) * cos(t), -pi/2..pi/2)
check every([0.5, 1, 1.5, 1.9], x => abs(total(section(ring, upright(x))) / spiric(x) - 1) < 1e-10)

// What lies beyond: at each place of the tube the angle of those that do.
fn beyond(x) = integrate((s, t) => 2 * s * (3 + s * cos(t)) * acos(x / (3 + s * cos(t))) / 1rad, [0..1, 0..tau])
check every([0.5, 1.5], x => abs(volume_of(cut(ring, upright(x), keep = "above")) / beyond(x) - 1) < 1e-10)

// Through the middle, along the tube: two circles of radius 3, their centres 2 apart, each less the lens that they share.
let slanted = plane((0, 0), (1, 0, sqrt(8)))
let lens = 18 * acos(1/3) / 1rad - sqrt(32)
check abs(total(section(ring, slanted)) / (18 * pi - 2 * lens) - 1) < 1e-10

// A spindle whose radius is 1 - z^2 at the height z, cut along its axis beside it.
let spindle = solid(revolve(bezier((0, 0, -1), (2, 0, 0), (0, 0, 1)), axis = (0, 0, 1)))
fn across(x) = integrate(z => 2 * sqrt((1 - z^2)^2 - x^2), -sqrt(1 - x)..sqrt(1 - x))
check every([0.1, 0.4, 0.7], x => abs(total(section(spindle, upright(x))) / across(x) - 1) < 1e-9)
