// Linkeova, exercise 2.2: the figure eight meets itself with equal curvature on the other side.
fn piece(c) = bezier(c[0], c[0] + c[1]/3, c[0] + 2*c[1]/3 + c[2]/3, c[0] + c[1] + c[2] + c[3])
let eight = [
    piece([(0, 0), (9, 9), (0, -9), (-3, 0)]), piece([(6, 0), (0, -9), (-9, 9), (3, 0)]),
    piece([(0, 0), (-9, 9), (0, -9), (3, 0)]), piece([(-6, 0), (0, -9), (9, 9), (-3, 0)]),
]
print [for i in 0..3: continuity(eight[i], eight[(i + 1) % 4]).g]
check [for i in 0..3: continuity(eight[i], eight[(i + 1) % 4]).c] == [1, 1, 1, 1]

// Vukasinovic & Duhovnik: collinear segments (1.59), opposite tangents (Fig. 1.34), parabolas
// (section 1.5.3).
curve f = line((0, 0, 0), (1, 2, 2))
curve g = line((1, 2, 2), (3, 6, 6))
print continuity(f, g)
print continuity(bezier((0, 0), (1, 2), (3, 3), (5, 3)), bezier((5, 3), (4, 3), (3, 1), (2, 0)))
let parabolas = continuity(bezier((-1, 0), (-1, 1), (0, 1)), bezier((0, 1), (1, 1), (1, 0)))
print [parabolas.c, parabolas.g]

// Apart: the gap tells how far. An infinite bend has no distance to others.
print continuity(f, line((1, 2, 2.5), (3, 6, 6)))
print continuity(bezier((0, 0), (1, 0), (1, 0)), line((1, 0), (2, 0))).curvature_gap
print continuity(bezier((0, 0), (1, 1), (1, 0), (1, 0)), line((1, 0), (1, -2))).curvature_gap

// Of one curve: its knots, and its seam where it is closed.
print continuity(circle((0, 0), 1))
print continuity(circle((0, 0), 1, form = "degree-5"))
print continuity(clamped([(0, 0), (1, 2), (3, 2), (4, 0), (6, 1)]))
print continuity(bezier((0, 0), (1, 2), (3, 2)))
check continuity(polyline((0, 0), (1, 0), (1, 1), (0, 0))).g == 0
// The tolerance of places is the document's: a gap below it is none.
check continuity(line((0, 0), (1, 0)), line((1, 9e-7), (2, 9e-7))).c == 3
check continuity(line((0, 0), (1, 0)), line((1, 2e-6), (2, 2e-6))).c == -1

// Where a curve turns back inside a piece it is C3 and has no direction to keep: G0.
let cusp = continuity(bezier((0, 0), (1, 1), (0, 1), (1, 0)))
check cusp.c == 3 and cusp.g == 0 and cusp.angle ~= 180deg
// (t³, t⁴) about t = 0 goes straight on, with a curvature that has no bound: y = x^(4/3).
let flat = continuity(polynomial([(0, 0), (0, 0), (0, 0), (1, 0), (0, 1)], domain = -1..1))
check flat.c == 3 and flat.g == 1 and flat.curvature_gap == none
// (t³, t⁶) is the parabola.
check continuity(polynomial([(0, 0), (0, 0), (0, 0), (1, 0), (0, 0), (0, 0), (0, 1)], domain = -1..1)).g == 3
// A leg that begins slowly has the direction of the next derivative: here straight on.
check continuity(line((0, 0), (1, 0)), bezier((1, 0), (1, 0), (2, 0))).g == 3
check continuity(line((0, 0), (1, 0)), bezier((1, 0), (1, 0), (0, 0))).g == 0
