// Solids through regions by the numbers that they are made of: against closed forms, and differences.
unit mm

// A frustum: pi h (r^2 + r s + s^2) / 3; its sides are pi (r + s) times the slant.
fn frustum(u) = skin([region(circle((0, 0, 0), u.r)), region(circle((0, 0, u.h), u.s))])
let cone = {r: 3mm, s: 1mm, h: 2mm}
let slant = sqrt((cone.r - cone.s)^2 + cone.h^2)
let of_volume = gradient(u => volume(frustum(u)), cone)
check of_volume.r ~= pi * cone.h * (2 * cone.r + cone.s) / 3 within 1e-9mm^2
check of_volume.s ~= pi * cone.h * (2 * cone.s + cone.r) / 3 within 1e-9mm^2
check of_volume.h ~= pi * (cone.r^2 + cone.r * cone.s + cone.s^2) / 3 within 1e-9mm^2
let of_area = gradient(u => area(frustum(u)), cone)
check of_area.r ~= pi * (slant + (cone.r + cone.s) * (cone.r - cone.s) / slant + 2 * cone.r) within 1e-9mm
check of_area.s ~= pi * (slant - (cone.r + cone.s) * (cone.r - cone.s) / slant + 2 * cone.s) within 1e-9mm
check of_area.h ~= pi * (cone.r + cone.s) * cone.h / slant within 1e-9mm
// Its centre is h/4 (r^2 + 2 r s + 3 s^2) / (r^2 + r s + s^2) up; about its axis it has pi h (r^5 - s^5) / (r - s) / 10.
check gradient(h => centroid(frustum({r: 3, s: 1, h: h})).z, 2) ~= 18 / 52 within 1e-10
check gradient(h => inertia(frustum({r: 3, s: 1, h: h})).tensor[2][2], 2) ~= 12.1 * pi within 1e-8
// Moved as a whole, and sheared, it holds as much.
check norm(gradient(p => volume(skin([region(circle(p, 3)), region(circle(p + (0, 0, 2), 1))])) / 1mm^3, (1, 2, 3))) < 1e-9
check gradient(p => volume(skin([region(circle((0, 0), 3)), region(circle(p, 3))])) / 1mm^3, (1, 2, 4)) ~= (0, 0, 9 * pi) within 1e-9
check gradient(p => volume(skin([region(circle((0, 0), 3)), region(circle(p, 3))])) / 1mm^3, (1, 2, -4)) ~= (0, 0, -9 * pi) within 1e-9

// A pipe: what its hole takes away of the volume and of both ends, its wall adds to the area.
fn disc(r, a, z) = region(circle((0, 0, z), r), holes = [circle((0, 0, z), a)])
fn pipe(u) = skin([disc(u.r, u.a, 0), disc(u.r, u.a, 5)])
check gradient(u => volume(pipe(u)) / 1mm^3, {r: 3, a: 2}) ~= {r: 30 * pi, a: -20 * pi} within 1e-9
check gradient(u => area(pipe(u)) / 1mm^2, {r: 3, a: 2}) ~= {r: 22 * pi, a: 2 * pi} within 1e-9

// A pyramid's stump between squares, whose sides are ruled: h/3 (a^2 + a b + b^2).
fn square(a, z) = region(polyline([(-a/2, -a/2, z), (a/2, -a/2, z), (a/2, a/2, z), (-a/2, a/2, z)], closed = true))
check gradient(u => volume(skin([square(u.a, 0), square(u.b, 6)])) / 1mm^3, {a: 4, b: 2}) ~= {a: 20, b: 16} within 1e-9
// Its border by curves one after the other, backwards, and with two holes.
fn pair(a, b) = line(a, b)
fn backwards(a, z) = region([pair((0, 0, z), (0, a, z)), pair((0, a, z), (a, a, z)), pair((a, a, z), (a, 0, z)), pair((a, 0, z), (0, 0, z))], holes = [circle((1, 1, z), a/8), circle((a - 1, 1, z), 0.5)])
check gradient(a => volume(skin([backwards(a, 0), backwards(a, 2)])), 4mm) ~= (16 - pi/4) * 1mm^2 within 1e-9mm^2

// What splines go through, bent along and across, closed, with tangents, and with an end that tilts.
fn ring(i, u) = region(interpolate([for k in 0..5: polar(2 + 0.3 * u.a * sin(1rad * (k + i)), k * 60deg) + (0, 0, 3 * i + u.b * i^2 / 4)], closed = true, parameters = "uniform"))
fn horn(u) = skin([for i in 0..2: ring(i, u)])
fn tilted(z, s, by) = region(polyline([(-s, -s, z - by), (s, -s, z + by), (s, s, z + by), (-s, s, z - by)], closed = true))
fn leaning(u) = skin([tilted(0, 2, 0), tilted(4, 1.5, u.a / 4), tilted(9, 1, u.b)])
fn bulged(u) = skin([region(circle((0, 0, 0), 2)), region(circle((0, 0, 3), u.a))], start_tangent = (0, 0, 3), end_tangent = (0, 0, 3))
fn tyre(u) = skin([for k in 0..3: region(circle(polar(6 + u.b, k * 90deg), u.a + 0.1 * k, normal = polar(1, k * 90deg + 90deg)))], closed = true, parameters = "uniform")
fn listed(u) = skin([for z in 0..2: disc(2 + 0.2 * u.a * z, 1 + 0.1 * u.b * z^2 / 4, 2 * z)], parameters = [0, 0.4, 1])
let at = {a: 1.2, b: 0.4}
fn are_like(f) = {
  let [exact, beside] = [gradient(f, at), gradient(f, at, differences = true)]
  abs(exact.a - beside.a) < 1e-5 * (1 + abs(beside.a)) and abs(exact.b - beside.b) < 1e-5 * (1 + abs(beside.b))
}
check every([horn, leaning, listed, bulged, tyre], f = body => are_like(u => volume(body(u)) / 1mm^3))
check every([leaning, bulged], f = body => are_like(u => area(body(u)) / 1mm^2))
check every([leaning, listed], f = body => are_like(u => dot(centroid(body(u)), (1, 2, -3))))
fn mixed(t) = (t[0][0] + 2 * t[0][1] - 3 * t[1][2] + 4 * t[1][1] - t[0][2]) / 100mm^5
check every([leaning, listed], f = body => are_like(u => mixed(inertia(body(u)).tensor)))

// Searches use them: the least sheet for a hopper of 100 ml.
let hopper = minimize(r => area(frustum({r: r, s: r, h: 1e5mm^3 / (pi * r^2)})), within = 20mm..40mm)
check hopper ~= cbrt(5e4 / pi) * 1mm within 1e-5
// As the volume says, by how much a radius goes with it.
fn to_hold(v) = solve(r => volume(frustum({r: r, s: r, h: 10mm})) - v, within = 10mm..90mm)
check gradient(to_hold, 1e5mm^3) ~= 1 / (20mm * pi * to_hold(1e5mm^3))
