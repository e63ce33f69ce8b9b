geo 1
unit mm
// Borders that run along one another, touch, and cross; parts, holes, offsets, fillets, in a plane askew.

let box_of = (x, y, w, h) => region(polyline([(x, y), (x + w, y), (x + w, y + h), (x, y + h)], closed = true))
let [a, b] = [box_of(0, 0, 4, 3), box_of(2, 1, 4, 3)]
regions joint = union(a, b)
regions common = intersection(a, b)
regions rest = difference(a, b)
check area(joint[0]) + area(common[0]) == area(a) + area(b)
check area(rest[0]) == 8
print joint, common, rest, joint[0].outer

// The same side, a corner, the same region.
print union(box_of(0, 0, 1, 1), box_of(1, 0.25, 1, 1)), union(box_of(0, 0, 1, 1), box_of(1, 1, 1, 1))
print difference(a, a), intersection(a, a) == [a], union([a, a], a)
check area(difference(a, box_of(0, 0, 4, 1), box_of(0, 2, 4, 1))[0]) ~= 4

// A frame of four bars has a hole.
regions bars = [box_of(0, 0, 3, 1), box_of(0, 2, 3, 1), box_of(0, 1, 1, 1), box_of(2, 1, 1, 1)]
let frame_of_bars = union(bars)[0]
print frame_of_bars, [for hole in frame_of_bars.holes: hole.closed]
check area(frame_of_bars) ~= 8

// In a plane askew: the same areas, and places in space.
let tilt = plane((5, 1, 2), (1, 1, 1))
let moved = [for r in [a, b]: rotate(r, 40deg, axis = (1, 2, 0))]
check area(union(moved)[0]) ~= area(joint[0])
check area(offset(moved[0], 0.5)[0]) ~= 12 + 7 + pi/4
print contains(moved[0], centroid(moved[0])), moved[0].plane.z.z > 0

// Offsets fall apart, close holes and vanish.
let dumbbell = union(box_of(0, 0, 4, 4), box_of(8, 0, 4, 4), box_of(3, 1.5, 6, 1))[0]
print offset(dumbbell, -0.6), offset(dumbbell, -3), offset(frame_of_bars, 0.6)
check [for c in ["round", "miter", "bevel"]: area(offset(a, 1, corner = c)[0])] ~= [26 + pi, 30, 28]

// Inward past the least radius of curvature, where offsets of the border turn back; each step takes what its border
// goes along. Exactly half the width of a slot leaves nothing.
region blob = region(interpolate([for i in 0..<8: polar(1 + 0.3*sin(i*3), i*360deg/8)], closed = true))
let steps = [for i in 0..12: offset(blob, -0.44 - 0.005*i)]
fn total(parts, f) = sum([for part in parts: f(part)])
check every(0..<12, i => total(steps[i], area) - total(steps[i + 1], area) ~= 0.0025mm*(total(steps[i], length) + total(steps[i + 1], length)) within 1e-5)
region slot = region(join([line((0, 0), (1, 0)), arc((1, 0.5), 0.5, -90deg, 90deg), line((1, 1), (0, 1)), arc((0, 0.5), 0.5, 90deg, 270deg)]))
print offset(slot, -0.5), offset(slot, -0.4)
check area(offset(slot, -0.4)[0]) ~= 0.2 + 0.01*pi

// Rounded corners: of lines, and between a line and an arc.
region half = region([arc((0, 0), 2, 0deg, 180deg), line((-2, 0), (2, 0))])
region soft = fillet(half, 0.25)
print half, soft, fillet(a, 0.5, at = [(4, 3)])
check area(fillet(a, 0.5)) ~= 12 - (4 - pi)*0.25
check bounds(soft).max.y ~= 2
fn roof(turn) = polyline([(0, 0), (2, 0), 2*(1, 0) + 2*(cos(turn), sin(turn)), (4, 3), (0, 3)], closed = true)
check every([1e-2, 1e-3, 1e-4, 2e-5], t => area(fillet(region(roof(t * 1rad)), 0.5, at = [(2, 0)])) ~= area(region(roof(t * 1rad))) within 1e-7)

// A sliver is meshed as closely as its sides ask for.
region sliver = region([line((0, 0), (10, 0)), arc_through((10, 0), (5, 0.01), (0, 0))])
check area(planar_mesh(sliver)) ~= area(sliver) within 0.01

// Outlines sorted by the even-odd rule.
print regions([circle((0, 0), 1), circle((0, 0), 3), circle((0, 0), 2), circle((9, 0), 1)])
table sums = table([for r in [a, half, soft]: {area: area(r), length: length(r), x: centroid(r).x}])
export rest to "rest.json"
export joint to "joint.svg"
export frame_of_bars to "frame.stl" with (binary = false)
