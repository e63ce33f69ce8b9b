// The box of a face whose border turns twice within a short way, against places of it; parameters far from 0.
surface s = bezier([
    [(0.0, 0, 0.0), (0.0, 10, 10.0)],
    [(2.5, 0, -1.252), (2.5, 10, 8.748)],
    [(5.0, 0, -11.037333333333333), (5.0, 10, -1.0373333333333328)],
    [(7.5, 0, 18.977333333333334), (7.5, 10, 28.977333333333334)],
    [(10.0, 0, -112.87466666666666), (10.0, 10, -102.87466666666666)],
])
face f = face(s, [polyline([(0, 0), (1, 0), (1, 1), (0, 0)])], space = "uv")
let on_diagonal = [for i in 0..2000: s(i / 10000, i / 10000).z]
check bounds(f).max.z ~= max(on_diagonal) within 1e-6
check bounds(f).min.z ~= s(1, 0).z within 1e-6

surface wave = bspline([for i in 0..5: [for j in 0..5: (2 * i, 2 * j, sin(2 * i) * cos(j))]])
surface late = reparametrize(wave, u = 200..201)
fn boxes(s) = [for p in split(s, plane((0, 0, 0.1), (0, 0, 1))): bounds(p)]
let [early_boxes, late_boxes] = [boxes(wave), boxes(late)]
check len(late_boxes) == 7
check every([for i in 0..6: distance(early_boxes[i].min, late_boxes[i].min) < 1e-5], x => x)
check every([for i in 0..6: distance(early_boxes[i].max, late_boxes[i].max) < 1e-5], x => x)

// A function that ends a little behind where it crosses another surface, at a small angle or touching it.
surface floor_plate = bezier([[(-1, -1), (-1, 2)], [(2, -1), (2, 2)]])
fn beside(s) = intersect(parametric((u, v) => (u, v, s * u), -5e-7 / s .. 1, 0..1), floor_plate)
check [for s in [0.01, 0.05, 0.1]: len(beside(s))] == [1, 1, 1]
check len(intersect(
    parametric((u, v) => (sin(u * 1rad), v, 1 - cos(u * 1rad)), -0.0009..1.5, 0..1),
    floor_plate,
)) == 1
check len(intersect(
    parametric((u, v) => (u, v, 0.02 * u + u * u), -0.00004..1, 0..1),
    floor_plate,
)) == 1
