// A common factor of the weights of an edge changes nothing of the surface between four edges.
geo 1

curve low = arc((0, 0), 1, 0deg, 60deg)
curve high = arc((0, 0, 2), 1, 0deg, 90deg)
curve left = line(low.start, high.start)
curve right = line(low.end, high.end)
fn weighed(c, factor) = nurbs(c.points, weights = [for w in c.weights: factor * w], degree = c.degree, knots = c.knots)
surface plain = edge_surface([low, right, high, left])
surface heavy = edge_surface([weighed(low, 3), right, weighed(high, 0.01), left])
check every(linspace(0, 1, 7), u => every(linspace(0, 1, 7), v => plain(u, v) ~= heavy(u, v) within 1e-12))
check every(linspace(0, 1, 7), t => closest(plain, low(t)).distance <= 1e-9 and closest(plain, high(t)).distance <= 1e-9)
