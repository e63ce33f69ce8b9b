// Sections of unlike weights stand by distances in homogeneous space, The NURBS Book, (10.14): about the first control
// point, so that a skin that is moved stays what it is.
geo 1

curves rings = [
    polyline([(-2, -2, 0), (2, -2, 0), (2, 2, 0), (-2, 2, 0)], closed = true),
    circle((0, 0, 2), 1),
    circle((0, 0, 3), 1.5),
    circle((0, 0, 6), 1),
]
fn moved(g) = rotate(translate(g, (100, -40, 7)), 0.7rad, axis = (1, 2, 3))
fn fifths(s) = [for i in 0..5: [for j in 0..5: s(lerp(s.domain_u.start, s.domain_u.end, i/5), j/5)]]

surface vase = skin(rings)
surface elsewhere = skin(moved(rings))
check report(elsewhere).parameters ~= report(vase).parameters within 1e-12
check fifths(elsewhere) ~= [for row in fifths(vase): [for p in row: moved(p)]] within 1e-11

// By places weights do not count, nor does the unit.
surface by_places = skin(rings, parameters = "places")
check report(skin(scale(moved(rings), 1000), parameters = "places")).parameters ~= report(by_places).parameters within 1e-12
check report(by_places).parameters[2] < 0.5371 and 0.537 < report(by_places).parameters[2]

// Regions are skinned by places.
let regions_of = [for c in rings: region(c)]
let body = skin(regions_of)
check volume(skin(moved(regions_of))) ~= volume(body) within 1e-10mm^3
check volume(skin(scale(regions_of, 100))) ~= 1e6 * volume(body) within 1e-4mm^3
check volume(skin([regions_of[0], regions_of[1]])) == volume(skin([regions_of[0], regions_of[1]], parameters = "average"))
