// The Utah teapot: 32 bicubic Bézier patches, checked for gaps, meshed and measured.
//
//     virote run teapot.geo --out out
//
// Martin Newell drew it in 1975; the numbers of teapot.bpt are millimetres here.

geo 1
unit mm

param tolerance_of_mesh = 0.2mm in 0.01mm..5mm "How far the mesh may lie from the surface"

surfaces patches = load("teapot.bpt")

check len(patches) == 32
check every(patches, f = p => p.degree_u == 3 and p.degree_v == 3)   "every patch is bicubic"

// The parts by the numbers of their patches. In the closed ones each patch is followed by its
// neighbour on the way around, and the last by the first; u runs down from the top.
fn part(name, numbers, closed = true) = {
    name,
    closed,
    patches: [for i in numbers: patches[i]],
}

let rim    = part("rim", [4, 5, 10, 11])
let upper  = part("upper body", [2, 3, 8, 9])
let lower  = part("lower body", [0, 1, 6, 7])
let ledge  = part("ledge", [22, 23, 20, 21])
let lid    = part("lid", [24, 25, 26, 27])
let knob   = part("knob", [28, 29, 30, 31])
let handle = part("handle", [12, 13, 14, 15], closed = false)
let spout  = part("spout", [16, 17, 18, 19], closed = false)
let parts  = [rim, upper, lower, ledge, lid, knob, handle, spout]

check sum([for p in parts: len(p.patches)]) == 32

// Where the parts are. Each bound is that of the surface itself, not of its control points.
fn box_of(p) = bounds(p.patches)
let extents = [for p in parts: "{p.name}: {box_of(p).min} to {box_of(p).max}"]
print extents

check box_of(lower).min.z ~= 0 and box_of(lower).max.z ~= 30      "the teapot stands on z = 0"
check box_of(upper).min.z ~= 30 and box_of(upper).max.z ~= 90     "the upper body begins where the lower one ends"
check box_of(upper).max.x ~= 80 and box_of(upper).min.y ~= -80    "the body is 160 mm wide"
check box_of(rim).max.z ~= 90 + 3/4 * 5.25                        "the rim is a cubic from 90 to 90 with both middle points at 95.25"
check box_of(ledge).min.z ~= 90 and box_of(ledge).max.z ~= 90     "the ledge under the lid is flat"
check box_of(knob).max.z ~= 120                                   "the knob is the top"
check box_of(handle).max.x < box_of(spout).min.x                  "the spout is opposite to the handle"

// Neighbours must share their edges, or the pot leaks. An edge of a patch is a row or a column of its
// control points; two edges are one curve when the points agree, in this order or in the other.
fn edge_points(p, side) =
    if side == "u0" then first(p.points)
    else if side == "u1" then last(p.points)
    else if side == "v0" then [for row in p.points: first(row)]
    else [for row in p.points: last(row)]

fn same_edge(a, b) = a ~= b or a ~= reverse(b)
fn joined(a, side_a, b, side_b) = same_edge(edge_points(a, side_a), edge_points(b, side_b))

/// Around a ring the edge v = 1 of each patch is the edge v = 0 of the next.
fn ring_closes(p) = every(0..3, f = i => joined(p.patches[i], "v1", p.patches[(i + 1) % 4], "v0"))

check every(filter(parts, p => p.closed), f = ring_closes)

/// Patch by patch the edge u = 0 of the lower part is the edge u = 1 of the one above.
fn stands_under(below, above) =
    every(zip(below.patches, above.patches), f = pair => joined(pair[0], "u0", pair[1], "u1"))

check stands_under(lower, upper)
check stands_under(upper, rim)
check stands_under(rim, ledge)
check stands_under(lid, knob)

/// Handle and spout are tubes of two halves that meet along both sides, in two lengths.
fn tube_closes(p) = {
    let [a, b, c, d] = p.patches
    joined(a, "v0", b, "v1") and joined(a, "v1", b, "v0")
        and joined(c, "v0", d, "v1") and joined(c, "v1", d, "v0")
        and joined(a, "u1", c, "u0") and joined(b, "u1", d, "u0")
}

check tube_closes(handle)
check tube_closes(spout)

// No pair was forgotten: of 128 edges, 52 pairs are shared, 4 are the tip of the knob, where the
// patches run together in a point, and 20 are free: foot, ledge, lid, and the ends of the tubes.
let sides = ["u0", "u1", "v0", "v1"]
let edges = [for p in patches, side in sides: edge_points(p, side)]
let lines = filter(
    edges,
    points_of_edge => not every(points_of_edge, f = p => p ~= points_of_edge[0]),
)
let shared = len([for i in 0..<len(lines), j in 0..<i if same_edge(lines[i], lines[j]): 1])

print len(edges), len(lines), shared
check len(edges) == 128
check len(edges) - len(lines) == 4
check shared == 52
check len(lines) - 2 * shared == 20

// One mesh of all patches, and a row of the table for each part.
mesh teapot = tessellate(patches, tolerance = tolerance_of_mesh)

table measures = table([for p in parts: {
    part: p.name,
    patches: len(p.patches),
    min: box_of(p).min,
    max: box_of(p).max,
}])

print teapot
print measures

export teapot to "teapot.obj"
export measures to "teapot.csv"
