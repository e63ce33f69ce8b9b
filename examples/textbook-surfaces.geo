// Surfaces of a textbook, with the numbers that it prints as claims: ruled, bilinear, Coons,
// Bézier and clamped surfaces from Linkeová, "Curves and Surfaces for Computer Graphics", chapter 3.

geo 1

// Example 3.1: straight lines between two parabolas.
curve low   = polynomial([(0, 0, 2), (2, 0, 0), (0, 0, -1)])
curve high  = polynomial([(0, 2, 2), (2, 0, -4), (0, 0, 2)])
surface ruled_one = ruled(low, high)
fn height_3_1(u, v) = 2 - 4*u*v - u^2 + 3*u^2*v
let steps = linspace(0, 1, 5)
check [for u in steps, v in steps: ruled_one(u, v)]
    ~= [for u in steps, v in steps: (2*u, 2*v, height_3_1(u, v))] within 1e-14 "Example 3.1"

// Example 3.5: the Coons surface of four parabolas, and the table of its corners.
curve left  = polynomial([(0, 0, 2), (0, 2, -4), (0, 0, 4)])
curve right = polynomial([(2, 0, 1), (0, 2, -2), (0, 0, 1)])
surface filled = coons(u = [low, high], v = [left, right])
fn height_3_5(u, v) = 2 - 4*v + 4*v^2 - u*v - 3*u*v^2 - u^2 + 3*u^2*v
check [for u in steps, v in steps: filled(u, v)]
    ~= [for u in steps, v in steps: (2*u, 2*v, height_3_5(u, v))] within 1e-14 "Example 3.5"
let corners_of_unit = [(0, 0), (0, 1), (1, 0), (1, 1)]
fn at_corners(du, dv) = [for c in corners_of_unit: derivative(filled, c.x, c.y, du = du, dv = dv)]
check at_corners(1, 0) ~= [(2, 0, 0), (2, 0, -4), (2, 0, -2), (2, 0, 0)] "tangent vectors along u"
check at_corners(0, 1) ~= [(0, 2, -4), (0, 2, 4), (0, 2, -2), (0, 2, 0)] "tangent vectors along v"
check at_corners(1, 1) ~= [(0, 0, -1), (0, 0, -7), (0, 0, 5), (0, 0, -1)] "twist vectors"

// It is the surface ruled along u, plus the one ruled along v, less the one of the corners.
surface corners_alone = corner_surface(low.start, low.end, high.end, high.start)
check [for u in steps, v in steps: filled(u, v)]
    ~= [
        for u in steps, v in steps:
        ruled(low, high)(u, v) + ruled(left, right)(v, u) - corners_alone(u, v)
    ] within 1e-14

// Example 3.11: a bicubic Bézier surface is the Coons surface of its edges, if the inner points fit.
surface bicubic = coons(
    u = [
        bezier((0, 0, 4), (1, 0, 1), (2, 0, 1), (3, 0, 4)),
        bezier((0, 3, 1), (1, 3, 1), (2, 3, 1), (3, 3, 1)),
    ],
    v = [
        bezier((0, 0, 4), (0, 1, 4), (0, 2, 1), (0, 3, 1)),
        bezier((3, 0, 4), (3, 1, 1), (3, 2, 1), (3, 3, 1)),
    ],
)
check [for i in 1..2, j in 1..2: bicubic.points[i][j]]
    ~= [(1, 1, 1), (1, 2, 0), (2, 1, 0), (2, 2, 0)] within 1e-14 "Theorem 3.1"
check [for u in steps, v in steps: bezier(bicubic.points)(u, v)]
    ~= [for u in steps, v in steps: bicubic(u, v)] within 1e-14

// Example 3.16: the same holds for clamped splines; the surface consists of six Bézier patches.
let knots_u = [0, 0, 0, 0, 1/2, 1, 1, 1, 1]
let knots_v = [0, 0, 0, 0, 1/3, 2/3, 1, 1, 1, 1]
surface clamped_one = coons(
    u = [
        bspline([(0, 0, 3), (1, 0, 4), (2, 0, 3), (3, 0, 0), (4, 0, 2)], knots = knots_u),
        bspline([(0, 5, 4), (1, 5, 0), (2, 5, 0), (3, 5, 0), (4, 5, 0)], knots = knots_u),
    ],
    v = [
        bspline(
            [(0, 0, 3), (0, 1, 3), (0, 2, 3), (0, 3, 1), (0, 4, 1), (0, 5, 4)],
            knots = knots_v,
        ),
        bspline(
            [(4, 0, 2), (4, 1, 0), (4, 2, 0), (4, 3, 2), (4, 4, 2), (4, 5, 0)],
            knots = knots_v,
        ),
    ],
)
check [for row in clamped_one.points: [for p in row: p.z]] ~= [
    [3, 3, 3, 1, 1, 4],
    [4, 19/6, 13/6, -2/3, -5/3, 0],
    [3, 31/18, 7/6, 1/3, -2/9, 0],
    [0, -3/2, -7/6, 2/3, 1, 0],
    [2, 0, 0, 2, 2, 0],
] within 1e-14 "Figure 3.22"
check clamped_one.patches == [2, 3]
check clamped_one(1/2, 1/2) ~= (2, 5/2, 1/2)
check derivative(clamped_one, 1/2, 1/2, du = 1, dv = 1) ~= (0, 0, 18) within 1e-12

print [for row in filled.points: [for p in row: p.z]]
export tessellate(
    [filled, translate(bicubic, (3, 0, 0)), translate(clamped_one, (7, 0, 0))],
    tolerance = 0.02,
) to "surfaces.obj"
