// To the right of the curve seen against the normal: counter-clockwise curves grow.
curve ring = offset(circle((1, 2), 2), 1)
check every([for t in linspace(0, 1, 50): abs(norm(ring(t) - (1, 2)) - 3) < 1e-14])
check offset(circle((0, 0), 2), -0.5)(0) ~= (1.5, 0) within 1e-15
check offset(circle((0, 0), 2, normal = (0, 0, -1)), 1, normal = (0, 0, -1))(0) ~= (3, 0) within 1e-15
check offset(line((0, 0), (3, 4)), 5).points ~= [(4, -3), (7, 1)] within 1e-15
curve square = polyline((0, 0), (4, 0), (4, 4), (0, 4), closed = true)
check offset(square, 1).points ~= [(-1, -1), (5, -1), (5, 5), (-1, 5), (-1, -1)] within 1e-14
check offset(square, -1).closed
// A parabola: C + d·(y', -x')/|C'|.
curve parabola = bezier((-1, 1), (0, -1), (1, 1))
curve beside = offset(parabola, 0.25)
fn wanted(x) = (x, x^2) + 0.25 * (2*x, -1) / sqrt(1 + 4*x^2)
check every([for t in linspace(0, 1, 101): norm(beside(t) - wanted(2*t - 1)) < 1e-6])
print beside.domain, beside.degree
// With the least radius of curvature, 1/2, the offset has a cusp; beyond it, two and a loop.
curve cusp = offset(parabola, -0.5)
curve loop = offset(parabola, -1)
// The corner outside is turned on an arc.
curve bow = join([conic((0, 0), (1, 1), (2, 0), 1), line((2, 0), (4, 0))])
print offset(bow, 0.5).domain, offset(bow, 0.5).start
curve inner = offset(bow, -0.5)
// A cusp of the curve itself, at no fraction that halving meets: around its tip.
curve tip = trim(bezier((0, 0), (1, 1), (0, 1), (1, 0)), 0.1..0.8)
check abs(bounds(offset(tip, 0.1)).max.y - (0.75 + 0.1)) < 1e-6
