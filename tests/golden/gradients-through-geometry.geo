// What geometry measures, by the numbers that it is made of: against closed forms, and differences.
unit mm

// A can: 2πrh and πr² of its volume, 4πr + 2πh and 2πr of its area.
fn can(u) = revolve(polyline((0, 0, 0), (u.r, 0, 0), (u.r, 0, u.h), (0, 0, u.h)))
let size = {r: 3mm, h: 5mm}
let of_volume = gradient(u => volume(can(u)), size)
check of_volume.r ~= 2 * pi * size.r * size.h
check of_volume.h ~= pi * size.r^2
let of_area = gradient(u => area(can(u)), size)
check of_area.r ~= 4 * pi * size.r + 2 * pi * size.h
check of_area.h ~= 2 * pi * size.r

// A ball: 4πr²; moved it holds as much, scaled 3s² times as much.
check gradient(r => volume(sphere((0, 0), r)), 2mm) ~= 16 * pi * 1mm^2
check norm(gradient(p => volume(translate(sphere(p, 1), p)) / 1mm^3, (1, 2, 3))) < 1e-9
check gradient(s => volume(scale(box((0, 0), (2, 3, 4)), s)) / 1mm^3, 2) ~= 3 * 4 * 24

// A bottle's body by the radii of its profile.
fn bottle(x) = revolve(clamped([(0, 0), (x[0], 0, 0), (x[1], 0, 40), (x[2], 0, 80), (x[3], 0, 120), (0, 0, 120)]))
let radii = [35, 42, 40, 14]
let by_radii = gradient(x => volume(bottle(x)) / 1mm^3, radii)
fn with_radius(i, h) = [for k in 0..3: if k == i then radii[k] + h else radii[k]]
check every(0..3, f = i => {
  let h = 1e-3
  let slope = (volume(bottle(with_radius(i, h))) - volume(bottle(with_radius(i, -h)))) / (2 * h) / 1mm^3
  abs(by_radii[i] - slope) < 1e-7 * slope
})
// A radius for a volume, and how it goes with the volume.
fn jar(r) = volume(bottle([r, r, r, r]))
check gradient(v => solve(r => jar(r) - v, within = 10mm..60mm), 200_000mm^3) ~= 1 / gradient(r => jar(r), solve(r => jar(r) - 200_000mm^3, within = 10mm..60mm))

// A sail between three corners: half the height over the opposite side, by each corner.
fn sail(u) = area(bilinear(u.tack, u.head, u.clew, u.head))
let corners = {tack: (0, 0), head: (0, 8), clew: (3, 0)}
let by_corner = gradient(sail, corners)
check by_corner.head ~= (0, 1.5, 0) within 1e-9
check by_corner.clew ~= (4, 0, 0) within 1e-9
check by_corner.tack ~= (-4, -1.5, 0) within 1e-9

// Curves: a polyline by its corner, a parabola by its point, weights, and what is made at listed parameters.
check gradient(p => length(polyline((0, 0), p, (8, 0))), (3, 4)) ~= (3/5 - 5/sqrt(41), 4/5 + 4/sqrt(41), 0)
check gradient(h => curvature(bezier((0, 0), (1, h), (2, 0)), 0.5), 2mm) ~= 1 / 1mm^2
check gradient(w => bezier([(0, 0), (1, 2), (2, 0)], weights = [1, w, 1])(0.5).y, 1) ~= 0.5
check gradient(p => interpolate([(0, 0), p, (2, 0)], degree = 2, parameters = [0, 0.5, 1])(0.25).y, (1, 1)) ~= (0, 0.75, 0)
check gradient(h => bezier((0, 0), (1, h), (2, 0)).points[1].y, 2) == 1
check gradient(h => bezier((0, 0), (1, h), (2, 0)).degree, 2) == 0
check gradient(r => length(circle((0, 0), r)), 2mm) ~= 2 * pi

// Nearest points, places by length, normals and isocurves of what varies.
check gradient(h => closest(line((0, h), (4, h)), (1, 3)).distance, 1mm) ~= -1
check gradient(r => closest(circle((0, 0), r), (3, 4)).point.x, 2) ~= 0.6
check gradient(r => closest(sphere((0, 0), r), (2, 1, 3)).distance, 1.1mm) ~= -1
check gradient(h => closest(plane_patch((0, 0, h), (1, 0), (0, 1)), (0.5, 0.5, 3)).distance, 1mm) ~= -1
check gradient(s => { let c = line((0, 0), (3*s, 4*s))
  c(parameter_at_length(c, 2)).x * s }, 1) ~= 1.2
check gradient(h => dot(normal(bilinear((0, 0), (0, 1), (1, 0, h), (1, 1, h)), 0.5, 0.5), (1, 0, 0)), 0) ~= -1
check gradient(h => bilinear((0, 0), (0, 1), (1, 0), (1, 1, h))(0.5, _)(0.5).z, 0) ~= 0.25
check gradient(a => rotate(line((0, 0), (2, 0)), a).end.y / 1mm * 1rad, 60deg) ~= 1
check gradient(h => length(reversed(trim(elevate(polyline((0, 0), (1, h), (2, 0)), 2), 0..1))), 1mm) ~= sqrt(0.5)

// A hull by the half breadths of its sections.
fn hull(b) = skin([for i in 0..4: bezier((10 * i, 0, 0), (10 * i, b[2*i], 0), (10 * i, b[2*i + 1], 4))], parameters = [0, 0.25, 0.5, 0.75, 1])
let breadths = [1, 2, 3, 5, 4, 6, 3, 5, 1, 2]
let by_breadth = gradient(b => area(hull(b)) / 1mm^2, breadths)
fn broader(i, h) = [for k in 0..9: if k == i then breadths[k] + h else breadths[k]]
check every(0..9, f = i => {
  let h = 1e-4
  abs(by_breadth[i] - (area(hull(broader(i, h))) - area(hull(broader(i, -h)))) / (2 * h) / 1mm^2) < 1e-6
})
// Centres of what surfaces enclose, and of the surfaces themselves.
fn keel(u) = centroid(scale(box((2, 0, 0), (3, 1, u.h)), u.b)).z
fn sheet(u) = centroid(bilinear((0, 0, 0), (0, u.b, 1), (3, 0, u.h), (3, 2, 0)), of = "area").x
check gradient(keel, {b: 2, h: 3}) ~= {b: 1.5, h: 1}
check every([keel, sheet], f = f => {
  let [at, d] = [{b: 2, h: 3}, 1e-5]
  let by = gradient(f, at)
  let by_b = (f({b: 2 + d, h: 3}) - f({b: 2 - d, h: 3})) / (2*d)
  let by_h = (f({b: 2, h: 3 + d}) - f({b: 2, h: 3 - d})) / (2*d)
  abs(by.b - by_b) < 1e-8 and abs(by.h - by_h) < 1e-8
})

// A ray through a ball about its start leaves it at 2 (5, y, 1) / sqrt(26 + y^2); a ball that grows, further out.
fn leaves(u) = intersect(line((0, 0), (5, u.y, 1)), sphere((0, 0), u.r))[0]
check gradient(u => leaves(u).point.y, {y: 3, r: 2}) ~= {y: 52 / 35^1.5, r: 3 / sqrt(35)} within 1e-9
check gradient(u => leaves(u).t, {y: 3, r: 2}) ~= {y: -6 / 35^1.5, r: 1 / sqrt(35)} within 1e-9
// Through the seam, as smoothly as elsewhere.
check gradient(z => intersect(sphere((0, 0), 2), line((0, 0), (5, 0, z)))[0].point.z, 1) ~= 50 / 26^1.5 within 1e-9

// Of a net of control points each acts by its own share.
fn net(h) = bspline([for i in 0..3: [for j in 0..3: (i, j, h[4 * i + j])]])
fn share(k) = [1, 3, 3, 1][k] / 8
check gradient(h => net(h)(0.5, 0.5).z, [for k in 0..15: k]) ~= [for k in 0..15: share(floor(k / 4)) * share(k % 4)] within 1e-12

// Searches use them: the sheet of a can.
let tin = minimize(u => area(can(u)), start = {r: 40mm, h: 40mm}, subject = u => volume(can(u)) ~= 1e6mm^3, report = true)
check tin.at.h ~= 2 * tin.at.r within 1e-3 and tin.derivatives == "exact"
print tin.derivatives
