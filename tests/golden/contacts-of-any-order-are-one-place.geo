// Curves that touch in order k part as x^k: within the tolerance of one another on a long way, but
// one place all the same, whatever their size, place and parameters.
geo 1

curve p = polynomial((0, 0), (1, 0), (0, 1), domain = -1..1)
curve axis = line((-1, 0), (1, 0))
fn power(k, factor = 1) = polynomial([(0, 0), (1, 0), ...[for i in 2..<k: (0, 0)], (0, factor)], domain = -1..1)
fn once(a, b, t) = {
    let found = intersect(a, b)
    len(found) == 1 and found[0].t ~= t within 1e-5
}

// The circle of curvature meets a parabola with threefold contact, and once more at -3t.
let third = intersect(p, osculating_circle(p, 0.2))
check len(third) == 2
check third[0].t ~= -0.6 within 1e-9
check third[1].t ~= 0.2 within 1e-9
// At its vertex the contact is fourfold, and there is no other.
check every([1, 1000, 1e-2], size => once(scale(p, size), scale(osculating_circle(p, 0), size), 0))

check every([3, 4, 5, 9, 12], k => once(power(k), axis, 0))
check once(power(3, factor = 100), axis, 0)
check every([1rad, 2rad], angle => once(rotate(power(9), angle), rotate(axis, angle), 0))
check once(translate(power(9), (1000, 300)), translate(axis, (1000, 300)), 0)
check once(scale(power(9), 1e5), scale(axis, 1e5), 0)
check once(insert_knot(insert_knot(power(9), 0.01), 0.02), axis, 0)
check once(reversed(power(9)), axis, 0)
check once(p, polynomial((0, 0), (1, 0), (0, 1), (0, 0), (0, 1), domain = -1..1), 0)

// Touches of fourth order beside one another are two places.
curve twice = polynomial((0, 2.56e-6), (1, 0), (0, -0.000256), (0, 0), (0, 0.0096), (0, 0), (0, -0.16), (0, 0), (0, 1), domain = -1..1)
let both = intersect(twice, axis)
check len(both) == 2
check both[0].t ~= -0.2 within 1e-4
check both[1].t ~= 0.2 within 1e-4

// At the vertices of an ellipse, over the seam as elsewhere.
curve e = ellipse((0, 0), 2, 1)
check every([0, 0.25, 0.5, 0.75], t => {
    let found = intersect(e, osculating_circle(e, t))
    len(found) == 1 and found[0].point ~= e(t) within 1e-5
})
check len(intersect(e, osculating_circle(e, 0.1))) == 2

// With a surface and a plane.
surface s = plane_patch((-1, -1), (2, 0), (0, 2))
fn raised(k, factor = 1) = polynomial([(0, 0), (1, 0), ...[for i in 2..<k: (0, 0)], (0, 0, factor)], domain = -1..1)
check every([2, 3, 4, 5, 9], k => once(raised(k), s, 0))
check every([2, 3, 4, 5, 9], k => section(raised(k), XY) ~= [(0, 0)] within 1e-5)
check section(insert_knot(raised(9), 0.01), XY) ~= [(0, 0)] within 1e-5

// A cusp touches where it stands, and is no meeting of a curve with itself.
curve cusp = polynomial((0, 0), (0, 0), (1, 0), (0, 1), domain = -1..1)
check once(cusp, axis, 0)
check self_intersections(cusp) == []
