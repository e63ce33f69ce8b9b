geo 1
// Corners that are not rounded cover their wedge and nothing beyond: where a border comes past one nearer than the
// distance, and where two sides that go on until they meet cross others. The areas are those of another library.

let of_corners = corners => region(polyline(corners, closed = true))
let kite = of_corners([(0, -0.9), (1.7, -0.9), (1, -0.5), (1.2, -0.2)])
let dart = of_corners([(1.6, 0.2), (0.7, 0.1), (1.2, 1), (-1.5, -1.2)])
let crown = of_corners([(0, -0.9), (1.1, -0.6), (1.7, -0.9), (1, -0.5), (1.7, -0.5), (1.2, -0.2)])
let fork = of_corners([(0, -0.9), (1.5, -1.2), (1.1, -0.6), (1.7, -0.9), (1.2, -0.2)])
let arrow = of_corners([(-0.04, -0.93), (1.68, -0.9), (0.97, -0.49), (1.7, -0.53), (1.2, -0.21)])

let total = regions => sum([for r in regions: area(r)])
check total(offset(kite, 0.5, corner = "bevel")) ~= 2.5407701091671377
check total(offset(dart, 0.5, corner = "bevel")) ~= 5.1846655312932635
check total(offset(crown, -0.1, corner = "bevel")) ~= 0.023236330383102945
check total(offset(fork, -0.1, corner = "miter")) ~= 0.2841724742961061
check total(offset(arrow, 0.5, corner = "miter")) ~= 5.12933427966119

// Past what lies on the other side of a border, and past corners that go on straight.
check total(offset(of_corners([(0, 0), (1, 0), (0, 1)]), 3, corner = "bevel")) ~= 21.606601717798206
check total(offset(of_corners([(0, 0), (2, 0), (2, 2), (0, 2), (0, 1.5)]), 1.5, corner = "bevel")) ~= 20.5

// No further than ten times the distance: there what cuts them off stands across.
let needle = of_corners([(0, 0), (20, -0.5), (20, 0.5)])
let grown = offset(needle, 0.1, corner = "miter")[0]
check bounds(grown).min.x ~= -1
check area(grown) ~= 14.29656854400968
// What is cut off lies inside of what is rounded, and that inside of what is mitred.
let styles = [for c in ["bevel", "round", "miter"]: offset(needle, 0.1, corner = c)]
check [for i in 0..1: difference(styles[i][0], styles[i + 1][0])] == [[], []]
print styles
