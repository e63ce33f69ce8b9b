// A study in one table: hulls of one displacement by length and breadth, each from the script of the Wigley hull
// with other parameters; their friction and their stability, and the best of those that stand upright.
// `virote study` does the like from outside, with thousands of variants and a file of results.
//
//     virote run hull-study.geo
//     virote run hull-study.geo --set displacement=1500 --set speed=8

geo 1
unit m

param displacement = 2500 in 1000..5000     "In cubic metres"
param speed = 6 in 2..10                   "In metres a second"
param centre = 0.5m in -2m..5m             "Height of the centre of gravity over the water"
param least = 0.5m in 0.1m..3m             "Least height of the metacentre over that"

// Friction by the line of the ITTC of 1957, in kilonewtons; sea water of 15 °C.
fn friction(wetted, length) = {
    let reynolds = speed * (length / 1m) / 1.19e-6
    let coefficient = 0.075 / (log10(reynolds) - 2)^2
    1025 / 2 * speed^2 * (wetted / 1m^2) * coefficient / 1000
}

// One variant. A Wigley hull grows evenly with each of its measures: one tells which draught is wanted.
let one = script("wigley-hull.geo")
let of_block = one.displacement / (one.length * one.beam * one.draught)
fn variant(length, beam) = {
    let draught = displacement * 1m^3 / (of_block * length * beam)
    let hull = script("wigley-hull.geo", length = length, beam = beam, draught = draught)
    {
        length,
        beam,
        draught,
        volume: hull.displacement,
        wetted: hull.wetted,
        friction: friction(hull.wetted, length),
        gm: hull.buoyancy.z + hull.metacentric_radius - centre,
        sides: [hull.port, hull.starboard],
    }
}
let hulls = [
    for length in [70m, 80m, 90m, 100m], beam in [11m, 12m, 13m, 14m]: variant(length, beam)
]
table study = table([for h in hulls: {
    length: h.length,
    beam: h.beam,
    draught: round(h.draught, 3),
    wetted: round(h.wetted, 1),
    friction: round(h.friction, 2),
    gm: round(h.gm, 3),
    upright: if h.gm >= least then "yes" else "no",
}])
print study

// Each is what it should be: the closed forms of the Wigley hull.
check every(hulls, h => h.volume ~= displacement * 1m^3 within 1e-6 * displacement)
check every(hulls, h => h.draught ~= 9/4 * displacement * 1m^3 / (h.length * h.beam) within 1e-9)
check every(hulls, h => h.gm ~= 3/35 * h.beam^2 / h.draught - 3/8 * h.draught - centre within 1e-9)

// The best of those that stand upright.
let upright = filter(hulls, h => h.gm >= least)
let best = {
    let _some = assert(upright != [], "none stands upright: lower the load, or let them be broader")
    upright[argmin([for h in upright: h.friction])]
}
print "best: {best.length:.0m} by {best.beam:.0m}, draught {best.draught:.2m}, {best.friction:.1} kN, gm {best.gm:.2} m"
export study to "hull-study.csv"

// All of them in rows of one length: those that stand upright, the others, and the best.
fn moored(h) = translate(h.sides, (11 * h.length, 25 * h.beam))
surfaces stable = flatten([
    for h in upright if h != best: moored(h)
]) with (color = "lightsteelblue")
surfaces tender = flatten([for h in hulls if h.gm < least: moored(h)]) with (color = "rosybrown")
surfaces chosen = moored(best) with (color = "seagreen")
