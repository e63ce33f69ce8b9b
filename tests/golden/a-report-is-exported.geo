/// The bracket <of> a door.
/// It holds 12|5 of *them*.
///
/// Second paragraph.
geo 1
unit cm

param width = 40mm in 10mm..80mm step 5mm "Width"
/// Stands on its edge.
param tilt: angle = 30deg
param finish = "matt" in ["matt", "a|b"]

region plate = region(polyline([(0, 0), (width, 0), (width, 2), (0, 2)], closed = true))

/// # Size
/// What it weighs depends on the area.
print area(plate), tilt, "the width is {width}"
check area(plate) ~= 8 "the area of a rectangle"
check length(plate) <= 20cm
check tilt < 31deg or width > 1m
check [for i in 1..3: i] == [1, 2, 3]
table corners = table([for p in [(0, 1/3), (width, 2)]: {x: p.x, y: p.y, about: "a|b `c` <d>"}])
/// # Corners
/// 1. Numbers of the lines are not a list.
print corners
print "x |> y `z`", sin(90)

/// For the saw.
export plate to "plate.dxf"
export report to "report.html" with (picture = false)
export report to "report.md" with (title = "Review: *the* bracket", decimals = 2, picture = false)
let empty = 1
