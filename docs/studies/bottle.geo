// A bottle of glass: how much it holds, and how much glass it takes.

geo 1
unit mm

param body     = 37mm in 25mm..70mm     "Radius of the body"
param height   = 250mm in 100mm..350mm  "Height"
param shoulder = 0.6 in 0.4..0.8        "Where the shoulder ends, as a part of the height"
param neck     = 13mm                   "Radius of the neck"
param wall     = 3mm                    "Thickness of the glass"

fn at_height(radius, fraction) = (radius, 0, fraction * height)

// Half of the inner outline: straight along body and neck, a smooth shoulder between.
curve outline = bspline([
    at_height(body, 0),
    at_height(body, 0.2),
    at_height(body, shoulder - 0.15),
    at_height(body, shoulder - 0.05),
    at_height(neck, shoulder + 0.05),
    at_height(neck, shoulder + 0.15),
    at_height(neck, 1),
])
surface inside = revolve(outline)
surface foot = disc(plane((0, 0, 0), (0, 0, -1)), body)
surface mouth = disc(plane((0, 0, height), (0, 0, 1)), neck)

let capacity = volume([inside, foot, mouth])
let litres = capacity / (100mm)^3
let glass = (area(inside) + area(foot)) * wall
// Glass weighs 2.5 g a cubic centimetre.
let grams = 2.5 * glass / (10mm)^3

let bend = max(curvature_table(outline).curvature)
check bend < 1 / 8mm "no bend is tighter than 8 mm"
check litres < 1.2 "it goes into the rack"

print litres, grams
