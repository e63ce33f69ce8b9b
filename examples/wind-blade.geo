// A blade of a wind turbine from a table of its stations: chord, twist and thickness by radius. Its sections
// are NACA profiles, turned about the quarter of the chord, and skinned.
// z runs along the blade, x the way that it turns, y with the wind.

geo 1
unit m

// What it was drawn for: speed of the tip over that of the wind, number of blades, coefficient of lift of the
// sections, and their angle of attack for that.
let [tip_speed, blades, lift, attack] = [7, 3, 1, 5deg]

let stations = load("wind-blade.csv")
let n = len(stations)
let radius = last(stations.r)

// The NACA 44xx: camber 4 % at 0.4 of the chord, with a closed tail. Abbott & von Doenhoff, Theory of Wing
// Sections, §6.4: the thickness stands at right angles to the camber line.
let [camber, at] = [0.04, 0.4]
fn middle(x) = if x < at then camber / at^2 * (2*at*x - x^2)
    else camber / (1 - at)^2 * (1 - 2*at + 2*at*x - x^2)
fn slope(x) = if x < at then 2*camber / at^2 * (at - x) else 2*camber / (1 - at)^2 * (at - x)
fn half(x, thick) = 5*thick * (0.2969*sqrt(x) - 0.1260*x - 0.3516*x^2 + 0.2843*x^3 - 0.1036*x^4)

// Around the section from the tail over the upper side, in parts of the chord from its quarter.
fn around(thick) = [for k in -20..20: {
    let x = (1 - cos(k * 9deg)) / 2
    let side = if k < 0 then 1 else -1
    let lean = atan(slope(x))
    let t = side * half(x, thick)
    (x - t * sin(lean) - 0.25, middle(x) + t * cos(lean))
}]

// A section in its place: the nose ahead and out of the rotor's plane against the wind, the upper side, which
// sucks, behind with the wind. All have their points at the same parameters, so that the skin needs no more
// control points than one of them.
fn section_at(row) = interpolate(
    [
        for p in around(row.thickness):
            rotate((-p.x, p.y) * row.chord / 1m, -row.twist) + (0, 0, row.r)
    ],
    parameters = "uniform",
)
curves sections = [for i in 0..<n: section_at(stations[i])] with (color = "firebrick")
surface blade = skin(sections)
face root = face(region(first(sections)))
face end  = face(region(last(sections)))
surfaces rotor = [for k in 0..<blades: rotate(blade, 1turn / blades * k, axis = (0, 1, 0))]

let inside = volume([blade, root, end])
print inside, centroid([blade, root, end]).z, area(blade)

// The table is the optimum of Schmitz (Gasch & Twele, Wind Power Plants, ch. 5), in millimetres and hundredths
// of a degree: with the angle φ between the wind and the rotor's plane far ahead.
fn phi(r) = atan(radius / (tip_speed * r))
let rows = [for i in 0..<n: stations[i]]
check every(rows, row =>
    16 * pi * row.r / (blades * lift) * sin(phi(row.r) / 3)^2 ~= row.chord within 0.5mm)
check every(rows, row => 2/3 * phi(row.r) - attack ~= row.twist within 0.005deg)

// Chord and twist, from the tail to the nose, are the table's; so is the thickness: the area between both
// sides of a camber line is 2 ∫ h ds, whatever its camber, since what one side gains the other loses.
fn chord_of(c) = c(0.5) - c.start
check every(0..<n, f = i => norm(chord_of(sections[i])) ~= rows[i].chord)
check every(0..<n, f = i => {
    let nose = chord_of(sections[i])
    atan2(-nose.y, nose.x) ~= rows[i].twist within 1e-9
})
check every(0..<n, f = i => {
    let of_one = 2 * integrate(x => half(x, rows[i].thickness) * hypot(1, slope(x)), 0..1)
    area(region(sections[i])) ~= of_one * rows[i].chord^2 within 2e-4 * rows[i].chord^2
})

// The volume is also what all sections add up to, each at one v.
fn height(v) = derivative(blade(0.5, _), v).z
check integrate(v => area(region(blade(_, v))) * height(v), blade.domain_v, tolerance = 1e-5)
    ~= inside within 1e-5
check every(linspace(0, 1, 21), f = v => is_planar(blade(_, v)))

let solidity =
    blades * integrate(v => norm(blade(0, v) - blade(0.5, v)) * height(v), 0..1) / (pi * radius^2)
print "the blades cover {100 * solidity:.2} % of the rotor's disc"
export blade, root, end to "wind-blade.step"
export table([
    for row in rows:
        {r: row.r, chord: row.chord, twist: row.twist, area: area(region(section_at(row)))}
]) to "wind-blade-sections.csv"
