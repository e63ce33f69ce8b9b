// Ventura, p. 23: the porcupine, away from the centre of curvature.
curve c = bezier((0, 0), (1, 2), (3, 2), (4, 0))
let comb = curvature_comb(c, samples = 5)
check len(comb.teeth) == 5
check [for tooth in comb.teeth: tooth.start] ~= [for t in linspace(0, 1, 5): c(t)] within 1e-15
check comb.teeth[0].end ~= (-0.21333333333333333, 0.10666666666666667) within 1e-15
check comb.teeth[2].end ~= (2, 113/54) within 1e-15
check comb.teeth[4].end ~= (4.2133333333333333, 0.10666666666666667) within 1e-14
check [for i in 0..4: comb.envelope(i/4)] ~= [for tooth in comb.teeth: tooth.end] within 1e-15
let inside = curvature_comb(c, samples = 5, scale = 2, side = "inside")
check inside.teeth[2].end ~= (2, 3/2 - 2*16/27) within 1e-15
check every([for i in 0..4: dot(comb.teeth[i].end - comb.teeth[i].start, tangent(c, i/4)) ~= 0 within 1e-15])
print comb

// A straight piece has teeth without length, and cells without a radius.
let straight = curvature_table(polyline((0, 0), (1, 0), (3, 0)), samples = 3)
print straight, straight[1]
check straight == straight and straight ~= straight
export straight to "straight.csv"
let bent = curvature_table(c, samples = 5)
check bent.curvature[2] ~= 16/27 within 1e-15
check bent.radius[2] ~= 27/16 within 1e-15
check bent.torsion ~= [0, 0, 0, 0, 0]

let basis = basis_table(circle((0, 0), 1), samples = 9)
print len(basis)
check [for i in 0..8: basis[i].n0 + basis[i].n1 + basis[i].n2 + basis[i].n3 + basis[i].n4 + basis[i].n5 + basis[i].n6 + basis[i].n7 + basis[i].n8] ~= [for i in 0..8: 1] within 1e-15

print [for a in arrows(c, "derivative", samples = 2): a.end - a.start]
print [for a in arrows(c, "second", samples = 2, scale = 0.5): a.end - a.start]
print len(arrows(c, "tangent")), len(arrows(polyline((0, 0), (1, 0)), "normal"))
surface s = bilinear((0, 0), (0, 1), (1, 0), (1, 1, 1))
print [for a in arrows(s, "twist", samples = 2): a.end - a.start]
print [for a in arrows([s, s], "tangent_u", samples = 2): a.start]
