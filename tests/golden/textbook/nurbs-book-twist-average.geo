// The NURBS Book: Averaging incompatible twists (last bullet of Sec 10.6)
geo 1
curve k0 = bezier((2, 0, 1), (3, 1, 0), (2, 2, 2))
curve l0 = bezier((0, 2, 1), (1, 3, 3), (0, 2, 0))
let sides = { u: (0, 6, 0), v: (6, 0, 0) }
let far = sides.u + sides.v
curve c0 = hermite([(0, 0), sides.u], [l0(0), (0, 5, 1)])
curve c1 = hermite([sides.v, far], [l0(1), (1, 4, 0)])
curve d0 = hermite([(0, 0), sides.v], [k0(0), (5, 0, 1)])
curve d1 = hermite([sides.u, far], [k0(1), (4, 1, 0)])
surface s = coons_bicubic(
    u = [c0, c1],
    v = [d0, d1],
    cross_u = [k0, line((5, 0, 1), (4, 1, 0))],
    cross_v = [l0, line((0, 5, 1), (1, 4, 0))],
)
check twist(s, 0, 0) ~= (2, 2, 1) within 2e-11
let corner = report(s).averaged_twists[0]
check [corner.cross_u, corner.cross_v, corner.twist] ~= [(2, 2, -2), (2, 2, 4), (2, 2, 1)] within 2e-11
