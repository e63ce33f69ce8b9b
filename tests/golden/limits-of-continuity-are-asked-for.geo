// A kink of half a degree in a straight line, of an edge in a plane.
curve kink = polyline((0, 0), (1, 0), (1 + cos(0.5deg), sin(0.5deg)))
check continuity(kink).angle ~= 0.5deg within 1e-12
check continuity(kink).g == 0
check continuity(kink, angle = 0.4deg).g == 0
check continuity(kink, angle = 0.6deg).g == 3
surface crease = extrude(kink, (0, 0, 1))
check continuity(crease).angle ~= 0.5deg within 1e-12
check continuity(crease, angle = 0.4deg).g == 0
check continuity(crease, angle = 0.6deg).g == 3

// Arcs of radii 10 and 9 along one tangent: their curvatures differ by 1/90.
curve wide = arc((0, 0), 10, 0deg, 90deg)
curve narrow = arc((0, 1), 9, 90deg, 180deg)
let bend = continuity(wide, narrow)
check bend.curvature_gap ~= 1/90 within 1e-12
check bend.g == 1
check continuity(wide, narrow, curvature_gap = 0.011).g == 1
check continuity(wide, narrow, curvature_gap = 0.0112).g == 2
surface wide_wall = extrude(wide, (0, 0, 3))
surface narrow_wall = extrude(narrow, (0, 0, 3))
fn walls(limit) = continuity(wide_wall, narrow_wall, "u1", "u0", curvature_gap = limit)
check walls(0.011).curvature_gap ~= 1/90 within 1e-12
check walls(0.011).g == 1
// As heights over their common plane neither has third derivatives.
check walls(0.0112).g == 3

// Two parabolas that are nearly one: curvatures 1 and 1 + 4e-11.
curve one = polynomial([(0, 0), (1, 0), (0, 0.5)], domain = -1..0)
curve other = polynomial([(0, 0), (1, 0), (0, 0.5 + 2e-11)], domain = 0..1)
check continuity(one, other).curvature_gap ~= 4e-11 within 1e-14
check continuity(one, other).c == 3 and continuity(one, other).g == 3
check continuity(one, other, curvature_gap = 1e-10).g == 3
check continuity(one, other, curvature_gap = 1e-11).g == 1
// What is asked for also limits what holds by the parameter.
check continuity(one, other, curvature_gap = 1e-11).c == 1

// A gap of 0.01, more than a thousandth of the size: what is asked for counts as it is.
curve left = line((0, 0), (1, 0))
curve right = line((1, 0.01), (2, 0.01))
check continuity(left, right).gap == 0.01
check continuity(left, right).g == -1
check continuity(left, right, tolerance = 0.009).g == -1
check continuity(left, right, tolerance = 0.011).g == 3
check continuity(left, right, tolerance = 0.011).c == 3
surface below = extrude(left, (0, 0, 1))
surface above = extrude(right, (0, 0, 1))
check continuity(below, above, "u1", "u0", tolerance = 0.009).g == -1
check continuity(below, above, "u1", "u0", tolerance = 0.011).g == 3

// Limits below rounding tell nothing apart that is one.
curve smooth = clamped([(0, 0), (1, 2), (3, 2), (4, 0), (6, 1)])
let strict = continuity(smooth, tolerance = 1e-30, angle = 1e-30rad, curvature_gap = 1e-30)
check strict.c == 2 and strict.g == 2

// `corners` counts the same angles as `continuity`, those below the root of the rounding too.
fn turned(e) = nurbs([(-3, 1), (-2, 0), (0, 0), (1, e), (2, 5)], degree = 2, knots = [0, 0, 0, 1, 1, 2, 2, 2])
let turns = [5e-10, 2e-9, 5e-9, 1.2e-8, 1e-7]
check [for e in turns: continuity(turned(e)).g == 0] == [false, true, true, true, true]
check [for e in turns: len(corners(turned(e))) == 1] == [false, true, true, true, true]

// What `join` takes for smooth is smooth to `continuity`, of surfaces too: far from the origin
// curvatures 1 and 1 + 4e-8 part the pieces by less than the rounding of a way to write them.
curve far_one = polynomial([(1e4, 0), (1, 0), (0, 0.5)], domain = -1..0)
curve far_other = polynomial([(1e4, 0), (1, 0), (0, 0.5 + 2e-8)], domain = 0..1)
check join([far_one, far_other]).knots == [-1, -1, -1, 1, 1, 1]
check continuity(far_one, far_other).g == 3
surface far_wall = extrude(far_one, (0, 0, 1))
surface far_next = extrude(far_other, (0, 0, 1))
check join([[far_wall], [far_next]]).knots_u == [-1, -1, -1, 1, 1, 1]
check continuity(far_wall, far_next, "u1", "u0").c == 3
check continuity(far_wall, far_next, "u1", "u0").g == 3
check continuity(far_wall, far_next, "u1", "u0", curvature_gap = 1e-8).g == 1
