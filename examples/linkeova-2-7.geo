// De Casteljau's algorithm on a curve of degree 6 at t = 1/2, with the printed triangle.
// Linkeová, Curves and Surfaces for Computer Graphics, example 2.7.

geo 1

curve c = bezier([(0, 2), (7, 9), (17, 9), (20, 4), (16, 0), (10, 0), (6, 4)])
check c.degree == 6

fn next_level(level, t) = [for leg in zip(level[0..-2], level[1..-1]): lerp(leg[0], leg[1], t)]
fn levels(polygon, t) =
    [polygon, ...scan(1..<len(polygon), polygon, (level, _n) => next_level(level, t))]

let triangle = levels(c.points, 1/2)

check [for level in triangle: len(level)] == [7, 6, 5, 4, 3, 2, 1]
check triangle ~= [
    [(0, 2), (7, 9), (17, 9), (20, 4), (16, 0), (10, 0), (6, 4)],
    [(7/2, 11/2), (12, 9), (37/2, 13/2), (18, 2), (13, 0), (8, 2)],
    [(31/4, 29/4), (61/4, 31/4), (73/4, 17/4), (31/2, 1), (21/2, 1)],
    [(23/2, 15/2), (67/4, 6), (135/8, 21/8), (13, 1)],
    [(113/8, 27/4), (269/16, 69/16), (239/16, 29/16)],
    [(495/32, 177/32), (127/8, 49/16)],
    [(1003/64, 275/64)],
] within 1e-13

// The tip of the triangle is the point of the curve; six times the leg above it is the derivative.
let point_of_curve = triangle[6][0]
let [left, right] = triangle[5]
print point_of_curve
check c(1/2) ~= point_of_curve within 1e-13
check derivative(c, 1/2) ~= 6 * (right - left) within 1e-12
check derivative(c, 1/2) ~= (39/16, -237/16) within 1e-12

// The ends, and the power form of the whole.
check [c(0), c(1)] == [(0, 2), (6, 4)]
check [derivative(c, 0), derivative(c, 1)] ~= [(42, 42), (-24, 24)] within 1e-12

let coefficients = [(0, 2), (42, 42), (45, -105), (-200, 40), (150, 60), (-30, -42), (-1, 7)]
fn power_form(t) = fold(reverse(coefficients), (0, 0), (value, next) => value * t + next)
let parameters = linspace(0, 1, 9)
check [for t in parameters: c(t)] ~= [for t in parameters: power_form(t)] within 1e-12

// One curve of legs per level, and the curve itself.
export c, [for level in triangle[0..-2]: polyline(level)] to "linkeova-2-7.obj"
