// One circle in four exact forms: Ventura's 9 and 7 points, and the NURBS Book's Example 7.10.

let forms = ["9-point", "7-square", "7-triangle", "degree-5"]
curves circles = [for form in forms: circle((2, 1), 5, form = form)]

print [for c in circles: c.degree]
print [for c in circles: len(c.points)]
print circles[1].knots
print circles[2].weights

// Every point of every form is on the circle.
fn misses(c) = [for t in linspace(0, 1, 201): abs(distance(c(t), (2, 1)) - 5)]
check every([for c in circles: max(misses(c)) < 1e-14])
check every([for c in circles: length(c) ~= 10 * pi within 1e-12])
check every([for c in circles, t in linspace(0, 1, 9): curvature(c, t) ~= 1 / 5 within 1e-10])

// They differ in speed: four quarters are nearly even, two halves twice as fast here as there.
fn speeds(c) = [for t in linspace(0, 1, 201): norm(derivative(c, t))]
let ratios = [for c in circles: round(100 * max(speeds(c)) / min(speeds(c))) / 100]
print ratios

// The other way round: an arc through three points closes to the same circle.
curve through = arc_through((7, 1), (2, 6), (-3, 1))
check through.segments == 2
check distance(through(0.3), (2, 1)) ~= 5 within 1e-14
check conic_kind(through) == "ellipse"
