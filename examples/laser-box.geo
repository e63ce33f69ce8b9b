// A box of six sheets with finger joints, cut by a laser: outlines are offset by half the width of the cut, so
// that fingers fit, and go to one drawing as closed paths.

geo 1
unit mm

param width = 80mm in 40mm..400mm  "Outer width"
param depth = 60mm in 40mm..400mm  "Outer depth"
param high  = 40mm in 30mm..400mm  "Outer height"
param sheet = 3mm in 1mm..10mm     "Thickness of the sheet"
param kerf  = 0.2mm in 0mm..1mm    "Width of the cut"

fn plate(x, y) = region(polyline([(0, 0), (x, 0), (x, y), (0, y)], closed = true))
fn bar(x0, y0, x1, y1) = region(polyline([(x0, y0), (x1, y0), (x1, y1), (x0, y1)], closed = true))

// Fingers along an edge of a length: every other of an odd number of equal parts.
fn n_fingers(length) = 2 * floor(length / (8 * sheet)) + 1
fn gaps(length, first) = {
    let n = n_fingers(length)
    [for i in 0..<n if i % 2 == first: [i * length / n, (i + 1) * length / n]]
}

// A sheet of x by y; on each edge the parts that belong to its neighbour are taken away.
fn cut(x, y, along_x, along_y) = difference(plate(x, y), [
    ...[for g in gaps(x, along_x): bar(g[0], -1mm, g[1], sheet)],
    ...[for g in gaps(x, along_x): bar(g[0], y - sheet, g[1], y + 1mm)],
    ...[for g in gaps(y, along_y): bar(-1mm, g[0], sheet, g[1])],
    ...[for g in gaps(y, along_y): bar(x - sheet, g[0], x + 1mm, g[1])],
])[0]

region floor_sheet = cut(width, depth, 1, 1)
region front       = cut(width, high, 0, 1)
region side        = cut(depth, high, 0, 0)

// Where two sheets meet, the fingers of one fill the gaps of the other.
fn fingers(r, x, length) = sum([
    for i in 0..<n_fingers(length):
        if contains(r, ((i + 0.5) * length / n_fingers(length), sheet / 2)) == "inside" then 1
        else 0
])
check fingers(floor_sheet, 0, width) + fingers(front, 0, width) == n_fingers(width)
check fingers(floor_sheet, 0, width) == (n_fingers(width) + 1) / 2
check area(floor_sheet) < width * depth

// The laser takes half of the cut on either side: outlines are that much larger.
fn outline(r) = offset(r, kerf / 2, corner = "miter")[0]
check area(outline(front)) ~= area(front) + length(front) * kerf / 2 within 0.02 * area(front)

let gap = 5mm
regions drawing = [
    outline(floor_sheet),
    translate(outline(floor_sheet), (0, depth + gap)),
    translate(outline(front), (width + gap, 0)),
    translate(outline(front), (width + gap, high + gap)),
    translate(outline(side), (width + gap, 2 * (high + gap))),
    translate(outline(side), (width + gap + depth + gap, 2 * (high + gap))),
]
print sum([for r in drawing: length(r)])
export drawing to "laser-box.dxf"
export drawing to "laser-box.svg"
