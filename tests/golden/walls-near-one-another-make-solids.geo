// Walls that come near one another, or together in an edge, go through nothing.
geo 1
unit mm

// A teardrop whose sides run together in a cusp, along the tangent of both.
curve drop = bezier((0, 0), (2, 0), (2, 1.5), (1, 0), (0, 0))
solid prism = solid(extrude(drop, (0, 0, 1)), cap = true)
check volume(prism) ~= area(region(drop))*1mm

// Legs of a pipe that miss one another by 0.02.
region disc = region(circle((0, 0), 0.3, normal = (1, 0, 0)))
curve hairpin = interpolate([(0, -1), (2, 0), (4, -1), (6, 0), (5, 2), (4, 1.5), (2, 0.65), (0, 1.5)])
check volume(sweep(disc, hairpin, tolerance = 1e-3)) ~= pi*0.09mm^2*length(hairpin) within 1e-2

// A wall as thin as a two thousandth of the size, a slit as narrow.
region wall = region(circle((0, 0), 1), holes = [circle((0, 0), 0.999)])
check volume(skin([wall, translate(wall, (0, 0, 1)), translate(wall, (0.3, 0, 2))])) ~= 2*pi*(1 - 0.999^2)

// Turns of a spring that come near one another.
curve coil = helix((0, 0), 2, 1.05, 3)
check volume(sweep(region(circle((0, 0), 0.5, normal = (1, 0, 0))), coil, tolerance = 1e-3)) ~= pi*0.25mm^2*length(coil) within 1e-2

// Edges along creased sides have bounds.
fn square(z, half) = region(polyline([(-half, -half, z), (half, -half, z), (half, half, z), (-half, half, z)], closed = true))
region across = region(polyline([(0, -1, -1), (0, 1, -1), (0, 1, 1), (0, -1, 1)], closed = true))
let creased = [
    sweep(across, line((0, 0), (5, 0))),
    sweep(across, polyline((0, 0, 0), (5, 0, 0), (5, 5, 0)), corner = "miter"),
    skin([square(0, 1), square(2, 2)]),
    skin([square(0, 1), square(2, 2), square(3, 1)]),
    solid(ruled(polyline([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)], closed = true), polyline([(-2, -2, 3), (2, -2, 3), (2, 2, 3), (-2, 2, 3)], closed = true)), cap = true),
]
check every(creased, s => report(s).deviation < 1e-9)
check every(creased, s => every(edges(s), e => report(e).proven))

// Slices of a cylinder, ten tolerances thick: 4/3 of the height times half of the width.
solid rod = solid(cylinder((0, 0), 1, 3), cap = true)
fn segment(h) = 3*(acos(1 - h)/1rad - (1 - h)*sqrt(2*h - h^2))
check every([1e-5, 1.2e-5, 2e-5], h => abs(volume(cut(rod, plane((1 - h, 0, 0), (1, 0, 0)), keep = "above"))/1mm^3 - segment(h)) < 1e-12)
