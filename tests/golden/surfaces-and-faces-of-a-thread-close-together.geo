geo 1
unit mm

// A quarter of a turn of a thread: strips between helices, closed by plane faces at both ends, whose straight sides
// are edges of the strips too.
let corners = [(4, -0.6), (4.2, -0.6), (5, -0.1), (5, 0.1), (4.2, 0.6), (4, 0.6)]
let turns = 0.25
fn screwed(p, turn) = (p.x * cos(turn * 1turn), p.x * sin(turn * 1turn), p.y + turn * 1.5)
fn strip(a, b) = parametric((u, v) => screwed(lerp(a, b, u), v), 0..1, 0..turns)
surfaces strips = [for i in 0..5: strip(corners[i], corners[(i + 1) % 6])]
faces ends = [for turn in [0, turns]: face(region(polyline([for p in corners: screwed(p, turn)], closed = true)))]

check every([0.1mm, 0.02mm, 0.005mm], t => check_mesh(tessellate([...strips, ...ends], tolerance = t)).closed)

// What a screw sweeps: the area of its section times the way of its centre around the axis.
region cross_section = region(polyline(corners, closed = true))
let expected = turns * tau * centroid(cross_section).x * 1mm * area(cross_section)
mesh m = tessellate(orient([...strips, ...ends]), tolerance = 0.001mm)
check check_mesh(m).closed and check_mesh(m).oriented
check volume(m) ~= expected within 1e-3 * expected
let exact = [for s in strips: to_nurbs(s, tolerance = 1e-6mm)]
check volume([...exact, ...ends]) ~= expected within 1e-6 * expected
print volume([...exact, ...ends]) / expected
