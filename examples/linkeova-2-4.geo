// A cubic Bézier curve, with the values that the textbook prints.
// Linkeová, Curves and Surfaces for Computer Graphics, example 2.4, (2.22)-(2.23).

geo 1

curve c = bezier((2, 3), (4, 2), (0, 0), (-1, 1))

// The coefficients of the power form, lowest first, and Horner's rule: from the highest
// coefficient down, times t, plus the next.
let printed = [(2, 3), (6, -3), (-18, -3), (9, 4)]
fn polynomial(coefficients, t) =
    fold(reverse(coefficients), (0, 0), (value, next) => value * t + next)
fn power_form(t) = polynomial(printed, t)

// Its derivative: each coefficient times its power, without the first.
let slopes = [for k in 1..3: k * printed[k]]
check slopes == [(6, -3), (-36, -6), (27, 12)]

let parameters = linspace(0, 1, 11)
check [for t in parameters: c(t)] ~= [for t in parameters: power_form(t)] within 1e-14
check [for t in parameters: derivative(c, t)]
    ~= [for t in parameters: polynomial(slopes, t)] within 1e-14

// Points and derivatives as printed.
check [for t in linspace(0, 1, 5): c(t)]
    ~= [(2, 3), (161/64, 17/8), (13/8, 5/4), (11/64, 3/4), (-1, 1)] within 1e-14
check [for t in linspace(0, 1, 5): derivative(c, t)]
    ~= [(6, -3), (-21/16, -15/4), (-21/4, -3), (-93/16, -3/4), (-3, 3)] within 1e-14

// De Casteljau's levels, here by recursion: a level, then the levels of the next one.
fn next_level(level, t) = [for leg in zip(level[0..-2], level[1..-1]): lerp(leg[0], leg[1], t)]
fn levels(polygon, t) =
    if len(polygon) == 1 then [polygon] else [polygon, ...levels(next_level(polygon, t), t)]

check levels(c.points, 1/4) ~= [
    [(2, 3), (4, 2), (0, 0), (-1, 1)],
    [(5/2, 11/4), (3, 3/2), (-1/4, 1/4)],
    [(21/8, 39/16), (35/16, 19/16)],
    [(161/64, 17/8)],
] within 1e-14
check levels(c.points, 1/2) ~= [
    [(2, 3), (4, 2), (0, 0), (-1, 1)],
    [(3, 5/2), (2, 1), (-1/2, 1/2)],
    [(5/2, 7/4), (3/4, 3/4)],
    [(13/8, 5/4)],
] within 1e-14
check levels(c.points, 3/4) ~= [
    [(2, 3), (4, 2), (0, 0), (-1, 1)],
    [(7/2, 9/4), (1, 1/2), (-3/4, 3/4)],
    [(13/8, 15/16), (-5/16, 11/16)],
    [(11/64, 3/4)],
] within 1e-14

// The first points of all levels are the control points of the curve's first part, and the
// last points, from the last level up, those of its second: the algorithm divides the curve.
let parts = levels(c.points, 1/4)
curve before = bezier([for level in parts: level[0]])
curve after = bezier([for level in reverse(parts): level[-1]])

check [for t in parameters: before(t)] ~= [for t in parameters: c(t / 4)] within 1e-14
check [for t in parameters: after(t)] ~= [for t in parameters: c(1/4 + t * 3/4)] within 1e-14

export c, before, after to "linkeova-2-4.obj"
