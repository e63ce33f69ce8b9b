// The NURBS Book: Gordon surface through a compatible 5x4 network ((10.28)-(10.33), A10.3)
geo 1
curve across0 = bspline([(0, -0.25, 2), (1.5, -0.25, -3), (4.5, -0.25, 0), (6, -0.5, 4), (8, 0, -1), (9.5, 0.5, 2)], degree = 3, knots = [0, 0, 0, 0, 0.3, 0.7, 1, 1, 1, 1])
curve across1 = bspline([
  (-0.375, 71/48, 13/6), (2.25, 11/6, -3.25), (4.1875, 41/24, 7/3), (139/24, 47/24, -5/6),
  (7.9375, 1.6875, -4/3), (469/48, 2, -4/3),
], degree = 3, knots = [0, 0, 0, 0, 0.3, 0.7, 1, 1, 1, 1])
curve across2 = bspline([
  (-5/12, 3.9375, -10/3), (2.5, 3.5625, -1), (175/48, 4.375, 1/12), (77/12, 185/48, 2.25),
  (101/12, 191/48, 10/3), (487/48, 4.25, -41/12),
], degree = 3, knots = [0, 0, 0, 0, 0.3, 0.7, 1, 1, 1, 1])
curve across3 = bspline([
  (1/12, 73/12, -2.5), (2.25, 275/48, 0), (13/3, 299/48, -2), (6.4375, 307/48, 11/6),
  (395/48, 151/24, 5/3), (9.75, 6.5, 2/3),
], degree = 3, knots = [0, 0, 0, 0, 0.3, 0.7, 1, 1, 1, 1])
curve across4 = bspline([(-0.5, 8.25, 2), (1.5, 7.75, -4), (4.5, 8.5, -1), (6.25, 8.5, 3), (8, 8.5, -3), (10, 8, 3)], degree = 3, knots = [0, 0, 0, 0, 0.3, 0.7, 1, 1, 1, 1])
curve along0 = bspline([(0, -0.25, 2), (-0.5, 1.5, 4), (-0.5, 4, -4), (0.5, 5.75, -4), (-0.5, 8.25, 2)], degree = 2, knots = [0, 0, 0, 0.4, 0.6, 1, 1, 1])
curve along1 = bspline([
  (3639/980, -79/280, -114/245), (215/56, 3939/1960, 88/245), (872/245, 7991/1960, 29/490),
  (2011/490, 2809/490, -209/245), (7341/1960, 809/98, -359/245),
], degree = 2, knots = [0, 0, 0, 0.4, 0.6, 1, 1, 1])
curve along2 = bspline([
  (6331/980, -597/1960, 454/245), (2381/392, 4231/1960, -648/245), (1658/245, 7699/1960, 1441/490),
  (477/70, 2991/490, 279/245), (1847/280, 8.5, 129/245),
], degree = 2, knots = [0, 0, 0, 0.4, 0.6, 1, 1, 1])
curve along3 = bspline([(9.5, 0.5, 2), (9.75, 2, -2), (10.25, 4.25, -4), (9.5, 6.5, 1), (10, 8, 3)], degree = 2, knots = [0, 0, 0, 0.4, 0.6, 1, 1, 1])
// the same network with the parameters given: at_u are those of the v-curves, at_v those of the u-curves
surface given = gordon(u = [across0, across1, across2, across3, across4], v = [along0, along1, along2, along3], at_u = [0, 3/10, 7/10, 1], at_v = [0, 1/5, 1/2, 4/5, 1])
check [for t in linspace(0, 1, 7): given(t, 0)] ~= [for t in linspace(0, 1, 7): across0(t)] within 1e-8
check [for t in linspace(0, 1, 7): given(t, 1/5)] ~= [for t in linspace(0, 1, 7): across1(t)] within 1e-8
check [for t in linspace(0, 1, 7): given(t, 1/2)] ~= [for t in linspace(0, 1, 7): across2(t)] within 1e-8
check [for t in linspace(0, 1, 7): given(t, 4/5)] ~= [for t in linspace(0, 1, 7): across3(t)] within 1e-8
check [for t in linspace(0, 1, 7): given(t, 1)] ~= [for t in linspace(0, 1, 7): across4(t)] within 1e-8
check [for t in linspace(0, 1, 7): given(0, t)] ~= [for t in linspace(0, 1, 7): along0(t)] within 1e-8
check [for t in linspace(0, 1, 7): given(3/10, t)] ~= [for t in linspace(0, 1, 7): along1(t)] within 1e-8
check [for t in linspace(0, 1, 7): given(7/10, t)] ~= [for t in linspace(0, 1, 7): along2(t)] within 1e-8
check [for t in linspace(0, 1, 7): given(1, t)] ~= [for t in linspace(0, 1, 7): along3(t)] within 1e-8
