// A quadratic Bézier curve, with the values that the textbook prints.
// Linkeová, Curves and Surfaces for Computer Graphics, example 2.3, (2.20)-(2.21).

geo 1

curve c = bezier((2, 0), (4, 1), (3, 2))

// Its power form as printed: x(t) = -3t^2 + 4t + 2, y(t) = 2t, and the derivative of that.
fn power_form(t) = (-3 * t^2 + 4 * t + 2, 2 * t)
fn power_form_of_derivative(t) = (-6 * t + 4, 2)

let parameters = linspace(0, 1, 9)
check [for t in parameters: c(t)] ~= [for t in parameters: power_form(t)] within 1e-14
check [for t in parameters: derivative(c, t)]
    ~= [for t in parameters: power_form_of_derivative(t)] within 1e-14

// Points and derivatives as printed.
check [for t in linspace(0, 1, 5): c(t)]
    ~= [(2, 0), (45/16, 1/2), (13/4, 1), (53/16, 3/2), (3, 2)] within 1e-14
check [for t in linspace(0, 1, 5): derivative(c, t)]
    ~= [(4, 2), (5/2, 2), (1, 2), (-1/2, 2), (-2, 2)] within 1e-14

// De Casteljau's algorithm in two lines. A level is one point shorter than the one before it:
// each of its points divides a leg of the polygon in the ratio t : 1 - t.
fn next_level(level, t) = [for leg in zip(level[0..-2], level[1..-1]): lerp(leg[0], leg[1], t)]

/// All levels, from the control polygon down to the point of the curve.
fn levels(polygon, t) =
    [polygon, ...scan(1..<len(polygon), polygon, (level, _n) => next_level(level, t))]

let at_half = levels(c.points, 0.5)
print at_half

check levels(c.points, 1/4) ~= [
    [(2, 0), (4, 1), (3, 2)],
    [(5/2, 1/4), (15/4, 5/4)],
    [(45/16, 1/2)],
] within 1e-14
check at_half ~= [
    [(2, 0), (4, 1), (3, 2)],
    [(3, 1/2), (7/2, 3/2)],
    [(13/4, 1)],
] within 1e-14
check levels(c.points, 3/4) ~= [
    [(2, 0), (4, 1), (3, 2)],
    [(7/2, 3/4), (13/4, 7/4)],
    [(53/16, 3/2)],
] within 1e-14

// The last level but one is the tangent: twice its leg is the derivative.
let [left, right] = at_half[1]
check 2 * (right - left) ~= derivative(c, 0.5) within 1e-14

export c, [for level in at_half[0..-2]: polyline(level)] to "linkeova-2-3.obj"
