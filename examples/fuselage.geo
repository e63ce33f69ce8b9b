// A fuselage lofted by conics: three lines along it, crown, side and keel, decide every frame, whose quarters are
// conics between them, exactly. Liming, Practical Analytic Geometry with Applications to Aircraft (1944).
// x runs aft from the nose, y to starboard, z upward.

geo 1
unit m

// The control points of the lines, one in each row. Two on one x round the nose off; four in a row keep a cabin
// straight.
let rows = [
    {x: 0, side: 0, crown: -0.3, keel: -0.3, waist: -0.3},
    {x: 0, side: 0.35, crown: 0, keel: -0.6, waist: -0.3},
    {x: 0.9, side: 0.8, crown: 0.4, keel: -0.9, waist: -0.25},
    {x: 2.5, side: 1.1, crown: 1.05, keel: -1.1, waist: -0.05},
    {x: 4.5, side: 1.15, crown: 1.15, keel: -1.15, waist: 0},
    {x: 7, side: 1.15, crown: 1.15, keel: -1.15, waist: 0},
    {x: 9.5, side: 1.15, crown: 1.15, keel: -1.15, waist: 0},
    {x: 12, side: 1.15, crown: 1.15, keel: -1.15, waist: 0},
    {x: 14.5, side: 0.95, crown: 1.15, keel: -0.6, waist: 0.2},
    {x: 17, side: 0.4, crown: 1, keel: 0.4, waist: 0.7},
    {x: 18, side: 0, crown: 0.85, keel: 0.85, waist: 0.85},
]
curve crown = clamped([for r in rows: (r.x, 0, r.crown)]) with (color = "firebrick")
curve side  = clamped([for r in rows: (r.x, r.side, r.waist)]) with (color = "firebrick")
curve keel  = clamped([for r in rows: (r.x, 0, r.keel)]) with (color = "firebrick")

// A quarter is tangent to the sides of its box; the weight of the corner makes it an ellipse.
let corner = sqrt(0.5)
fn quarter(corners) = nurbs(
    [for r in rows: corners(r)],
    weights = [for r in rows: [1, corner, 1]],
    degree = {u: 3, v: 2},
    knots = {u: crown.knots, v: [0, 0, 0, 1, 1, 1]},
)
surface upper = quarter(r => [(r.x, 0, r.crown), (r.x, r.side, r.crown), (r.x, r.side, r.waist)])
surface lower = quarter(r => [(r.x, r.side, r.waist), (r.x, r.side, r.keel), (r.x, 0, r.keel)])
surface starboard = join([[upper, lower]]) with (color = "lightsteelblue")
surface port = mirror(starboard, ZX) with (color = "lightsteelblue")

// Frames are curves of the surface, and ellipses: above and below the side of another height.
let frames_at = linspace(0.1, 7.8, 15)
fn on_ellipse(u, v) = {
    let p = starboard(u, v)
    let top = if v < 1 then crown(u).z else keel(u).z
    (p.y / side(u).y)^2 + ((p.z - side(u).z) / (top - side(u).z))^2
}
check every(
    frames_at,
    f = u => every(linspace(0, 2, 9), f = v => on_ellipse(u, v) ~= 1 within 1e-12),
)
check every(frames_at, f = u => starboard(u, 1) ~= side(u))

// Nothing shows: along the side the halves of a frame have one tangent, above and below port has the same as
// starboard, and along the fuselage there is no jump in the curvature.
check every(frames_at, f = u => continuity(starboard(u, _)).g >= 1)
check every(
    frames_at,
    f = u => abs(normal(starboard, u, 0).y) < 1e-12 and abs(normal(starboard, u, 2).y) < 1e-12,
)
check every([0.1, 0.5, 0.9, 1.3, 1.7], f = v => continuity(starboard(_, v)).g >= 2)

// What is inside: by the surfaces, and by the areas of the frames, π/2 times half the breadth times the height.
fn frame_area(u) = pi / 2 * side(u).y * (crown(u).z - keel(u).z)
let inside = volume([starboard, port])
let slices = integrate(u => frame_area(u) * derivative(crown, u).x, 0..8)
check inside ~= slices within 1e-9 * inside
let skin = 2 * area(starboard)
print "{inside:.2} inside of {skin:.2} of skin, centre {centroid([starboard, port]).x:.2} m behind the nose"

// The cabin: round windows, which are what a drill from the side leaves, and a floor.
let windows_at = [for k in 0..7: 5.2m + k * 0.8m]
curves windows = [
    for x in windows_at:
        intersect(starboard, cylinder((x, 0.6, 0.3), 0.16m, 1, axis = (0, 1, 0)))[0]
]
face shell = face(starboard, [for w in windows: reversed(w)]) with (color = "lightsteelblue")
check every(0..7, f = k => every(linspace(0, 1, 9), f = t => {
    let p = windows[k](lerp(windows[k].domain.start, windows[k].domain.end, t))
    hypot(p.x - windows_at[k] / 1m, p.z - 0.3) ~= 0.16
}))
let low = -0.65m
let line_of_floor = section(starboard, plane((0, 0, low), (0, 0, 1)))[0]
let middle_line = line(line_of_floor.end, line_of_floor.start)
region floor = intersection(
    region([line_of_floor, middle_line]),
    region(polyline([(4, -1, low), (12, -1, low), (12, 2, low), (4, 2, low)], closed = true)),
)[0] with (color = "peru")
check bounds(floor).max.y ~= 1.15 * sqrt(1 - (0.65 / 1.15)^2)                "an ellipse of 1.15 m both ways"
print "the floor is {2 * area(floor):.2} large and {2 * bounds(floor).max.y:.3} m wide"

curves frames = [for u in frames_at: starboard(u, _)] with (color = "seagreen")
export starboard, port to "fuselage.step"
export table([for u in linspace(0, 8, 17): {
    x: crown(u).x,
    breadth: 2 * side(u).y,
    height: crown(u).z - keel(u).z,
    area: frame_area(u),
}]) to "fuselage-frames.csv"
