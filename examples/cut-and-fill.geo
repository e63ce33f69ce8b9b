// Cut and fill of a building site: the ground as it was levelled on a grid, a plane with a fall for the water,
// the bodies of earth between both, and the height of the plane at which cut and fill balance.
//
//     virote run cut-and-fill.geo
//     virote run cut-and-fill.geo --set fall=0.02 --set shrinkage=0

geo 1
unit m

param fall = 0.01 in 0..0.05            "Fall of the plane along x"
param shrinkage = 0.1 in 0..0.3         "What is lost where earth is packed, as a part of the cut"

let survey = load("cut-and-fill.csv")
let [xs, ys] = [survey.x, range(0, 120, 20)]
fn levels(i) = [for y in ys: survey["y {y}"][i]]
surface ground = interpolate(
    [for i in 0..<len(xs): [for j in 0..<len(ys): (xs[i], ys[j], levels(i)[j])]],
    parameters = {u: [for x in xs: x / 1m], v: ys},
) with (color = "olivedrab")
let [along, across] = [max(xs), max(ys) * 1m]

// The plane by its height at x = 0, and what is between two sheets of the same sides.
fn sheet(z, drop, margin) = bilinear(
    (-margin, -margin, z + drop * margin), (-margin, across + margin, z + drop * margin),
    (along + margin, -margin, z - drop * (along + margin)),
    (along + margin, across + margin, z - drop * (along + margin)),
)
fn walls(a, b) = [for e in ["u0", "u1", "v0", "v1"]: ruled(edge(a, e), edge(b, e))]
fn between(a, b) = tessellate(orient([a, b, ...walls(a, b)]), tolerance = 0.01m)
mesh soil = between(ground, sheet(50, 0, 0)) with (hidden = true)
mesh air  = between(ground, sheet(150, 0, 0)) with (hidden = true)
fn cut_by(z)  = intersection(soil, between(sheet(z, fall, 1), sheet(200, 0, 1)))
fn fill_by(z) = intersection(air, between(sheet(z, fall, 1), sheet(0, 0, 1)))

let level = solve(z => (1 - shrinkage) * volume(cut_by(z)) - volume(fill_by(z)), within = 95m..106m)
mesh cut  = cut_by(level) with (color = "firebrick")
mesh fill = fill_by(level) with (color = "steelblue")
print "the plane begins at {level:.2m}: {volume(cut):.0} are cut, {volume(fill):.0} filled"
check (1 - shrinkage) * volume(cut) ~= volume(fill) within 1e-6 * volume(fill)       "nothing is carted away"

// What is cut less what is filled is the ground's volume over the plane's: by the surfaces themselves, by the rule
// of the site, a mean of four corners for each square, and by the integral of the heights that were surveyed,
// z = 100 + 2 sin(πx/160) + 3 (y/120)² - x/40, rounded to centimetres.
let site = along * across
let net = volume(cut) - volume(fill)
let plane_mean = level - fall * along / 2
let base = sheet(50, 0, 0)
let ground_mean = 50m + volume([ground, base, ...walls(ground, base)]) / site
let squares = [
    for i in 0 ..< len(xs) - 1, j in 0 ..< len(ys) - 1:
    mean([levels(i)[j], levels(i)[j + 1], levels(i + 1)[j], levels(i + 1)[j + 1]])
]
print ground_mean, mean(squares)
check ground_mean ~= 99m + 4m / pi within 0.002
check net / site ~= ground_mean - plane_mean within 0.001
check net / site ~= mean(squares) - plane_mean within 0.005
let over = (x, y) => 100 + 2 * sin(pi * x / 160) + 3 * (y / 120)^2 - x / 40 + fall * x - level / 1m
let heights = integrate((x, y) => max(over(x, y), 0), [0..160, 0..120], tolerance = 20)
check volume(cut) ~= heights within 0.005 * volume(cut)

// Where neither is: the line at which the plane leaves the ground. And stakes for the survey's grid.
curves zero = intersect(ground, sheet(level, fall, 0)) with (color = "black")
curves heights_of_ground = contours(
    ground,
    (0, 0, 1),
    [for z in 97..103: z],
) with (color = "saddlebrown")
export zero to "cut-and-fill.dxf"
export table([for i in 0..<len(xs), j in 0..<len(ys): {
    x: xs[i],
    y: ys[j],
    ground: levels(i)[j],
    plane: level - fall * xs[i],
    dig: levels(i)[j] - (level - fall * xs[i]),
}]) to "cut-and-fill-stakes.csv"
