// Uniform clamped cubics as chains of Bézier cubics that join with continuous second derivatives.
// Linkeová, Curves and Surfaces for Computer Graphics, exercise 2.26 a)-d), figure 2.26.

geo 1

// The control polygon of each curve, and the polygons of its Bézier segments.
let cases = [
    {
        name: "a",
        polygon: [(1, 1), (3, 1), (5, 7), (7, 1), (9, 4)],
        segments: [
            [(1, 1), (3, 1), (4, 4), (5, 4)],
            [(5, 4), (6, 4), (7, 1), (9, 4)],
        ],
    },
    {
        name: "b",
        polygon: [(4, 1), (1, 3), (1, 7), (7, 7), (7, 3), (10, 1)],
        segments: [
            [(4, 1), (1, 3), (1, 5), (2, 6)],
            [(2, 6), (3, 7), (5, 7), (6, 6)],
            [(6, 6), (7, 5), (7, 3), (10, 1)],
        ],
    },
    {
        name: "c",
        polygon: [(3, 1), (1, 3), (3, 7), (6, 1), (9, 7), (7, 7), (6, 5)],
        segments: [
            [(3, 1), (1, 3), (2, 5), (3, 5)],
            [(3, 5), (4, 5), (5, 3), (6, 3)],
            [(6, 3), (7, 3), (8, 5), (8, 6)],
            [(8, 6), (8, 7), (7, 7), (6, 5)],
        ],
    },
    {
        name: "d",
        polygon: [(4, 5), (3, 7), (1, 7), (4, 1), (7, 7), (10, 1), (8, 1), (7, 3)],
        segments: [
            [(4, 5), (3, 7), (2, 7), (2, 6)],
            [(2, 6), (2, 5), (3, 3), (4, 3)],
            [(4, 3), (5, 3), (6, 5), (7, 5)],
            [(7, 5), (8, 5), (9, 3), (9, 2)],
            [(9, 2), (9, 1), (8, 1), (7, 3)],
        ],
    },
]

// A clamped curve has one unit of parameter a segment, so that segment i runs from i to i + 1.
curves splines = [for case in cases: clamped(case.polygon)]
check [for c in splines: c.segments] == [2, 3, 4, 5]
check [for c in splines: c.knots] == [
    [0, 0, 0, 0, 1, 2, 2, 2, 2],
    [0, 0, 0, 0, 1, 2, 3, 3, 3, 3],
    [0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4],
    [0, 0, 0, 0, 1, 2, 3, 4, 5, 5, 5, 5],
]

/// The Bézier points of segment i, from values and derivatives at its ends: a cubic is
/// given by these four. At a knot the derivative to the left equals that to the right.
fn bezier_points(c, i) = [
    c(i),
    c(i) + derivative(c, i) / 3,
    c(i + 1) - derivative(c, i + 1) / 3,
    c(i + 1),
]

check [for c in splines: [for i in 0..<c.segments: bezier_points(c, i)]]
    ~= [for case in cases: case.segments] within 1e-13

// Between its ends each segment is the Bézier curve of these points.
curves pieces = [for case in cases, polygon in case.segments: bezier(polygon)]
fn samples(c, from) = [for t in linspace(0, 1, 7): c(from + t)]
check [for c in splines, i in 0..<c.segments: samples(c, i)]
    ~= [for piece in pieces: samples(piece, 0)] within 1e-13

// Side by side, as the figure has them.
curves side_by_side = [for k in 0..3, polygon in cases[k].segments:
    translate(bezier(polygon), (11 * (k % 2), -8 * floor(k / 2)))]

// Neighbours join with their second derivatives: 6 times the second difference of the points.
fn second_at_start(p) = 6 * (p[0] - 2 * p[1] + p[2])
fn second_at_end(p) = 6 * (p[1] - 2 * p[2] + p[3])
fn joints(segments) = zip(segments[0..-2], segments[1..-1])
check [for case in cases, joint in joints(case.segments): second_at_end(joint[0])]
    ~= [for case in cases, joint in joints(case.segments): second_at_start(joint[1])] within 1e-13

let counts = [for i in 0..3: "{cases[i].name}: {splines[i].segments} segments"]
print counts

export splines to "linkeova-exercise-2-26.obj"
export table([for k in 0..3, i in 0..<splines[k].segments: {
    curve: cases[k].name,
    segment: i,
    start: bezier_points(splines[k], i)[0],
    end: bezier_points(splines[k], i)[3],
}]) to "linkeova-exercise-2-26.csv"
