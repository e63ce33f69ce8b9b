// Joints of the textbooks with their verdicts: c by the parameter, g by the shape.

geo 1

fn verdict(a, b) = {
    let k = continuity(a, b)
    [k.c, k.g]
}

// Linkeova, Curves and Surfaces for Computer Graphics, exercise 2.2: Ferguson cubics in the form of
// an eight. Where it crosses itself the curvatures are equal and the curvature vectors opposite.
fn ferguson(a, b, u, v) = bezier(a, a + u/3, b - v/3, b)
let stops = [(0, 0), (6, 0), (0, 0), (-6, 0), (0, 0)]
let speeds = [(9, 9), (0, -9), (-9, 9), (0, -9), (9, 9)]
let eight = [for i in 0..3: ferguson(stops[i], stops[i + 1], speeds[i], speeds[i + 1])]
print [for i in 0..3: verdict(eight[i], eight[(i + 1) % 4])]
check curvature(eight[1], 1) ~= curvature(eight[2], 0) within 1e-12
check verdict(eight[1], eight[2]) == [1, 1] "equal numbers are not equal vectors"
check verdict(eight[0], eight[1])[1] >= 2

// Vukasinovic and Duhovnik, Advanced CAD Modeling, (1.59): collinear segments of other speed.
check verdict(line((0, 0, 0), (1, 2, 2)), line((1, 2, 2), (3, 6, 6))) == [0, 3]

// Fig. 1.34: one tangent line, but opposite directions.
let p = bezier((0, 0), (1, 2), (3, 3), (5, 3))
let r = bezier((5, 3), (4, 3), (3, 1), (2, 0))
print continuity(p, r)
check verdict(p, r) == [0, 0]

// Section 1.5.3: two parabolas with one osculating circle.
check verdict(bezier((-1, 0), (-1, 1), (0, 1)), bezier((0, 1), (1, 1), (1, 0))) == [1, 2]

// Piegl and Tiller, The NURBS Book, example 7.2: a circle is smooth, its homogeneous curve is not.
print continuity(circle((0, 0), 1))
check continuity(circle((0, 0), 1)).c_homogeneous == 0
