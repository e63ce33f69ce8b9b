// Where functions stay zero together, their unknowns have derivatives by all that the functions depend on.
fn at(r) = solve(p => [norm(p) - r, p.y - 2*p.x], start = (1, 1))
check gradient(r => at(r).x, 5) ~= 1/sqrt(5) within 1e-9
check gradient(u => solve(v => [v.a + v.b - u.s, v.a * v.b - u.p], start = {a: 1, b: 4}).a, {s: 5, p: 6}) ~= {s: -2, p: 1} within 1e-9
// The place where a curve of given control points crosses a line, by a control point.
check gradient(h => solve(t => bezier((0, 0), (1, h), (3, -2))(t).y, start = 0.6), 2) ~= 1/9 within 1e-9
// Of all orders, as a curve.
curve rooted = parametric(t => solve(p => [p.x^2 + p.y^2 - 25, p.y - t*p.x], start = (3, 3)), 0.5..2)
check every([0.5, 1, 2], t => norm(rooted(t)) ~= 5 within 1e-12)
check every([0.6, 1, 1.7], t => curvature(rooted, t) ~= 1/5 within 1e-9)
// The start may depend on them too: the root does not.
check gradient(a => solve(x => x^2 - a, start = a), 4) ~= 0.25 within 1e-9
