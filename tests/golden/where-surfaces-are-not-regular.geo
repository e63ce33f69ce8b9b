surface ball = parametric((u, v) => (cos(u)*cos(v), sin(u)*cos(v), sin(v)), 0..tau, -pi/2..pi/2)
surface fan = bilinear((0, 0), (0, 0), (1, 0), (1, 1))
surface crossed = bilinear((0, 0), (0, 1), (1, 1), (1, 0))
surface tip = bezier([[(0, 0), (0, 1), (0, 2)], [(0, 0.5), (1, 1), (1, 2)], [(2, 0), (2, 1), (2, 2)]])
surface lipped = bezier([[(0, 0), (0, 1)], [(3, 0), (3, 1)], [(-2, 0), (-2, 1)], [(1, 0), (1, 1)]])
check describe(ball).collapsed == ["v0", "v1"] and describe(ball).folds == []
check describe(fan).collapsed == ["u0"] and describe(fan).singular == []
check describe(tip).collapsed == [] and describe(tip).singular == [(0, 0)] "both tangents run along one line"
check every([for p in describe(crossed).folds: abs(p.x - 0.5) < 1e-6]) and len(describe(crossed).folds) > 0
// x' = 9 - 48 u + 48 u^2 vanishes at 1/4 and 3/4.
check every([for p in describe(lipped).folds: abs(abs(p.x - 0.5) - 0.25) < 1e-9]) and len(describe(lipped).folds) > 1
check describe(bilinear((0, 0), (0, 1), (1, 0), (1, 1))).folds == []
check len(arrows(ball, "tangent_u", samples = 3)) == 9 "at the poles too, as limits"
print describe(fan)
