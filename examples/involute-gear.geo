// A pair of spur gears: flanks that are involutes within a tenth of a micron, the span that a workshop measures,
// and the pair turning without touching.
//
//     virote run involute-gear.geo
//     virote run involute-gear.geo --set pinion=23 --set module=1mm
//
// Names and formulas are those of ISO 21771.

geo 1
unit mm

param module = 2mm in 0.5mm..10mm        "Module"
param pinion: integer = 19 in 17..60     "Teeth of the small gear"
param wheel: integer  = 31 in 17..80     "Teeth of the large gear"
param play = 0.1mm in 0.02mm..0.3mm      "Play on the pitch circles"
let pressure = 20deg
let accuracy = 1e-4mm

// Radii by the number of teeth: of the base circle, of tip and root.
fn base(z) = module * z / 2 * cos(pressure)
fn tip(z)  = module * (z / 2 + 1)
fn root(z) = module * (z / 2 - 1.25)

// An involute starts on the base circle; t is the angle that has been unwound. `inv` is its polar angle where
// it is met at an angle of pressure.
fn inv(angle) = tan(angle) * 1rad - angle
fn unwound(z, radius) = sqrt(max((radius / base(z))^2 - 1, 0))
fn involute(z) = parametric(
    t => base(z) * (cos(t) + t * sin(t), sin(t) - t * cos(t)),
    unwound(z, root(z))..unwound(z, tip(z)),
)
fn flank(z) = to_nurbs(involute(z), accuracy)

// How far a place is from the involute, along its normal: along that all involutes of a circle are as far from
// one another as along the circle.
fn beside(z, p) = base(z) * (atan2(p.y, p.x) - inv(acos(min(base(z) / norm(p), 1)))) / 1rad
fn worst(z) = {
    let c = flank(z)
    let t = maximize(t => abs(beside(z, c(t))), within = c.domain)
    abs(beside(z, c(t)))
}
print len(flank(pinion).points), worst(pinion), worst(wheel)
check worst(pinion) < accuracy and worst(wheel) < accuracy     "the flanks are involutes"

// A tooth about the x axis and the root beside it, counter-clockwise. Below the base circle it is radial.
fn half_tooth(z) = (pi * module - play) / (2 * module * z) * 1rad + inv(pressure)
fn tooth(z) = {
    let up   = rotate(flank(z), -half_tooth(z))
    let down = reversed(mirror(up, ZX))
    let at   = p => atan2(p.y, p.x)
    let legs = if root(z) < base(z) - 1um then [
        line(polar(root(z), at(up.start)), up.start),
        line(down.end, polar(root(z), at(down.end))),
    ] else [none, none]
    filter([
        legs[0], up, arc((0, 0), tip(z), at(up.end), at(down.start)), down, legs[1],
        arc((0, 0), root(z), at(down.end), at(up.start) + 1turn / z),
    ], c => c != none)
}
fn gear(z) = {
    let outline = region(flatten([for k in 0..<z: rotate(tooth(z), k * 1turn / z)]))
    let beside  = half_tooth(z) - inv(acos(min(base(z) / root(z), 1)))
    let corners = [for k in 0..<z, side in [-1, 1]: polar(root(z), k * 1turn / z + side * beside)]
    let rounded = fillet(outline, 0.2 * module, at = corners)
    rounded.outer |> region(holes = [circle((0, 0), 0.15 * module * z)])
}
region small = gear(pinion)
region large = gear(wheel)

// The span over k teeth, between parallel faces that touch the flanks: along a tangent of the base circle.
fn span(z, k) =
    module * cos(pressure) * (pi * (k - 0.5) + z * inv(pressure) / 1rad) - play / 2 * cos(pressure)
fn measured(r, z, k) = {
    let reach = span(z, k) / 2 + 0.2 * pi * module
    let across = rotate(
        line((base(z), -reach), (base(z), reach)),
        if k % 2 == 1 then 0deg else 180deg / z,
    )
    let hits = intersect(across, r.outer)
    distance(first(hits).point, last(hits).point)
}
fn over(z) = ceil(z / 9)
let spans = [for g in [[small, pinion], [large, wheel]]: measured(g[0], g[1], over(g[1]))]
check spans ~= [span(pinion, over(pinion)), span(wheel, over(wheel))] within 2 * accuracy
print "over {over(pinion)} teeth of the pinion {spans[0]:.3mm}, over {over(wheel)} of the wheel {spans[1]:.3mm}"

// In mesh: the wheel's gap about the pinion's tooth, both turned by a part of a tooth, the pinion a bit further.
let apart = module * (pinion + wheel) / 2
fn turned(part, ahead) = [
    rotate(small, part * 1turn / pinion + ahead),
    translate(rotate(large, (wheel / 2 + 0.5 - part) * 1turn / wheel), (apart, 0)),
]
let contact = play / (module * pinion) * 1rad
let parts = linspace(0, 1, 6)
check every(parts, part => intersection(turned(part, 0.99 * contact)) == [])       "they turn freely"
check every(parts, part => intersection(turned(part, 1.01 * contact)) != [])       "until the play is used up"

// How many pairs of teeth carry at a time: the way of contact over the pitch of the base circles.
fn leg(z) = sqrt(tip(z)^2 - base(z)^2)
let ratio = (leg(pinion) + leg(wheel) - apart * sin(pressure)) / (pi * module * cos(pressure))
print "the axes are {apart:.2mm} apart, {ratio:.3} pairs of teeth carry"
check ratio > 1.2

regions pair = turned(0.3, 0deg) with (color = "steelblue")
export small to "involute-gear-pinion.dxf"
