// Exact edits leave a curve where it was.
curve c = bspline([(0, 0), (1, 3), (3, 4), (4, 1), (6, 0), (7, 3), (9, 2), (10, 1)], degree = 3, knots = [0, 0, 0, 0, 0.2, 0.2, 0.2, 0.8, 1, 1, 1, 1])
fn same(a, b) = every([for t in linspace(0, 1, 21): norm(a(t) - b(t)) < 1e-14])
check same(insert_knot(c, 0.5, times = 2), c)
check same(refine(c, [0.1, 0.9, 0.1]), c)
check same(elevate(c, 6), c)
check same(reversed(reversed(c)), c)
check same(join(split(c, 0.5)), c)
check same(join(decompose(c)), c)
check join(decompose(c)).knots ~= c.knots
check remove_knot(insert_knot(c, 0.5), 0.5, 1e-9).points ~= c.points within 1e-12
check reduce(elevate(c, 5), 1e-9).points ~= c.points within 1e-12
check reversed(c)(0.25) ~= c(0.75) within 1e-14
check reparametrize(c, 10..30)(15) ~= c(0.25) within 1e-14
check trim(c, 0.25..0.75)(0.4) ~= c(0.4) within 1e-14
print trim(c, 0.25..0.75).domain, split(c, 0.2)[0].knots, split(c, 0.2)[1].knots
check len(to_bezier(c)) == 3
// The knot 0.2 stands three times: the curve passes through a control point there.
check c(0.2) ~= (4, 1, 0)
