// Half the thickness of a four-digit aerofoil, with a closed tail.
fn half(x, t) = 5*t*(0.2969*sqrt(x) - 0.126*x - 0.3516*x^2 + 0.2843*x^3 - 0.1036*x^4)
let xs = [for i in 0..24: 0.5*(1 + cos(180deg*i/24))]
fn foil(z, chord, twist, t) = {
    let up = [for x in xs: (chord*(x - 0.25), chord*half(x, t), 0)]
    let low = [for i in 1..24: (chord*(xs[24 - i] - 0.25), -chord*half(xs[24 - i], t), 0)];
    translate(rotate(interpolate([...up, ...low]), twist), (0, 0, z))
}
let foils = [foil(4, 2, 20deg, 0.3), foil(8, 1.6, 10deg, 0.24), foil(12, 1.1, 4deg, 0.18), foil(16, 0.5, 0deg, 0.15)]
let tails = [for f in foils: f.start]

// Behind a round root the seams stay at the tails.
surface blade = skin([circle((0, 0, 0), 0.4), ...foils])
let at = report(blade).parameters
check every(0..3, k => norm(blade(0, at[k + 1]) - tails[k]) < 1e-12)
print report(blade).moved_seams
// Also of sections that begin at their noses, or run the other way.
let nosed = [for f in foils: { let p = split(f, 0.5) join([p[1], p[0]]) }]
surface turned = skin([circle((0, 0, 0), 0.4), nosed[0], reversed(nosed[1]), foils[2], nosed[3]])
let stand = report(turned).parameters
check every(0..3, k => norm(turned(0, stand[k + 1]) - tails[k]) < 1e-12)
print report(turned).reversed
// With `align = false` they stay as they are.
surface as_given = skin(nosed, align = false)
check norm(as_given(as_given.domain_u.start, 0) - nosed[0].start) < 1e-12

// Neighbours with as many corners have them at the same parameters, exactly.
fn box(z, w, h, inner) = nurbs([(w, h, z), (-w, h, z), (-w, -h, z), (w, -h, z), (w, h, z)], degree = 1, knots = [0, 0, ...inner, 1, 1])
surface duct = skin([box(0, 1, 1, [0.25, 0.5, 0.75]), box(2, 3, 1, [0.375, 0.5, 0.875])])
print duct.knots_u, report(duct).moved_corners
check duct(0.375, 1) ~= (-3, 0, 2)
// A circle beside corners has its seam there; other numbers of corners are told.
let wedge = polyline((1, 0, 4), (0, 1, 4), (-1, -1, 4), (1, 0, 4))
surface round = skin([circle((0, 0, 0), 1), box(2, 1, 1, [0.25, 0.5, 0.75])])
check round(0, 0) ~= (sqrt(1/2), sqrt(1/2), 0) within 1e-9
surface odd = skin([box(2, 1, 1, [0.25, 0.5, 0.75]), wedge])

// Sections of one form have one set of knots, whatever their sizes and turns: their skin needs no more points than they.
let alike = [for k in 0..3: foil(4*(k + 1), [2, 1.6, 1.1, 0.5][k], [20deg, 10deg, 4deg, 0deg][k], 0.2)]
check len(alike[0].points) == 51
check len(skin(alike).points) == 51 and len(skin(alike).points[0]) == 4
check report(skin(alike)).moved_seams == []
