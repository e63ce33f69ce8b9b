// A bend of a road: straight, clothoid, arc, clothoid, straight, between two tangents; its heights; and the
// carriageway with its crossfall. Stations are lengths along the axis in plan.
//
//     virote run road.geo
//     virote run road.geo --set radius=450m --set turn=55deg

geo 1
unit m

param radius = 300m in 120m..2000m     "Radius R of the arc"
param scale  = 150m in 60m..1000m      "Parameter A of the clothoids"
param turn   = 40deg in 10deg..120deg  "By how much the road turns, to the left"
param lead   = 300m in 100m..2000m     "From the start to where the tangents meet, and from there to the end"
param speed  = 80 in 30..130           "Kilometres in an hour"
param width  = 8m in 5m..15m           "Width of the carriageway"

// A clothoid has the curvature s/A² and the direction s²/2A²; from the straight to the arc it takes A²/R.
let ramp  = scale^2 / radius
let swing = ramp / (2 * radius) * 1rad
curve clothoid = to_nurbs(parametric(
    s => s * integrate(k => polar(1, (k * s * 1m)^2 / (2 * scale^2) * 1rad), 0..1),
    0 .. ramp / 1m,
), 1e-6)
check 2 * swing < turn                                      "there is room for an arc"
check radius / 3 <= scale and scale <= radius               "the clothoid is felt, and no more"

// Its end by the series of Fresnel's integrals.
fn factorial(n) = product([for k in 1..max(n, 1): k])
fn series(odd) = sum([
    for n in 0..7: (-1)^n * (swing / 1rad)^(2*n + odd) / factorial(2*n + odd) / (4*n + 1 + 2*odd)
])
check clothoid.end ~= ramp / 1m * (series(0), series(1)) within 1e-5

// The arc is shifted from the tangents by what the clothoids need.
let shift = clothoid.end.y - radius * (1 - cos(swing))
let inset = clothoid.end.x - radius * sin(swing)
let reach = (radius + shift) * tan(turn / 2) + inset
check reach < lead                                        "there is room for the bend"

// One half is the other's image.
let meet   = (lead, 0)
let begin  = (lead - reach, 0)
let half   = [
    reparametrize(line((0, 0), begin), 0 .. (lead - reach) / 1m),
    translate(clothoid, begin),
]
let middle = arc(begin + (inset, radius + shift), radius, swing - 90deg, turn - swing - 90deg)
let image  = plane(meet, polar(1, turn / 2))
curve axis = join([...half, middle, ...[for c in reverse(half): reversed(mirror(c, image))]])

let of_arc = radius * (turn - 2 * swing) / 1rad
let total  = 2 * (lead - reach) + 2 * ramp + of_arc
check length(axis) ~= total within 1e-5
check continuity(axis).g >= 2                               "no jump in the curvature"

// Stations where the elements meet, and what is at a station: its place, the curvature, the crossfall down to the
// left, the height.
let marks = [lead - reach, ...scan([ramp, of_arc, ramp], lead - reach, (s, l) => s + l)]
fn between(s, a, b) = clamp((s - a) / (b - a), 0, 1)
fn in_bend(s) = between(s, marks[0], marks[1]) - between(s, marks[2], marks[3])
let [straight_fall, bend_fall] = [0.025, 0.06]

// Down by 2 %, up by 1.5 %, with a parabola between them that is as round as a circle of 6000 m.
let [down, up, sag] = [0.02, 0.015, 6000m]
let bottom = total / 2
let rounding = sag * (down + up) / 2
fn height(s) = {
    let x = clamp(s, bottom - rounding, bottom + rounding) - (bottom - rounding)
    120m - down * min(s, bottom + rounding) + x^2 / (2 * sag) + up * max(s - bottom - rounding, 0m)
}
fn at_station(s) = {
    let t = parameter_at_length(axis, s)
    let along = tangent(axis, t)
    {
        station: s,
        place: axis(t) + (0, 0, height(s)),
        direction: atan2(along.y, along.x),
        bend: signed_curvature(axis, t),
        crossfall: lerp(straight_fall, bend_fall, in_bend(s)),
        left: cross((0, 0, 1), along),
    }
}
let stations = [...range(0, total / 1m, 10), total / 1m]
let rows = [for s in stations: at_station(s * 1m)]

// Along a clothoid the curvature grows with the station, in the arc it stays.
check every(rows, row => {
    row.bend ~= (
        if row.station > marks[3] or row.station < marks[0] then 0m^-1
            else in_bend(row.station) / radius
    ) within 1e-8
})

let lowest = minimize(s => height(s), within = 0m..total)
check lowest ~= bottom - rounding + down * sag within 1e-2 "where the parabola is level"
check height(lowest) ~= 120m - down * (bottom - rounding) - down^2 * sag / 2
let pull = (speed / 3.6)^2 / (9.81 * radius / 1m)
print "{length(axis):.2m} of axis, {ramp:.1m} in each clothoid, lowest at {lowest:.1m}"
print "at {speed} km/h the arc wants {pull:.3} g to the side, of which the crossfall gives {bend_fall:.3}"

// The edges of the carriageway, the surface between them, and what to set out.
fn edge_of(side) = interpolate([
    for row in rows: row.place + side * width / 2 * (row.left - (0, 0, row.crossfall))
])
curve left  = edge_of(1)
curve right = edge_of(-1)
surface carriageway = ruled(left, right) with (color = "dimgray")
curve centre = interpolate([for row in rows: row.place + (0, 0, 0.05)]) with (color = "white")
print area(carriageway)
check area(carriageway) > width * total and area(carriageway) < 1.003 * width * total  "as in plan, and a bit for slopes"
export axis, left, right to "road.dxf"
export table([
    for row in rows if row.station % 50m == 0: {
        station: row.station,
        place: row.place,
        direction: row.direction,
        bend: row.bend,
        crossfall: row.crossfall,
    }
]) to "road-stations.csv"
