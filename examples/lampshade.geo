// A lampshade: a turned sheet with a pattern of holes, each a circle of its parameters. The holes grow towards
// the rim; the light that they let through is told, and the sheet is exact in STEP.

geo 1
unit mm

param rows   = 4 in 1..12            "Rows of holes"
param around = 10 in 3..40           "Holes in a row"
param height = 220mm in 100mm..400mm "Height of the shade"

curve profile = bezier((50, 0, 0), (95, 0, 0.25 * height), (90, 0, 0.7 * height), (130, 0, height))
surface sheet = revolve(profile)

// In the plane of u and v a hole is an ellipse; clockwise, so that what is around it stays.
let tall = 0.4 / (rows + 1)
let wide = 0.32 / around
fn hole(i, k) = {
    let size = 0.4 + 0.6 * i / max(rows - 1, 1)
    let center = ((k + if i % 2 == 0 then 0.34 else 0.66) / around, (i + 1) / (rows + 1))
    reversed(ellipse(center, size * wide, size * tall))
}
let holes = flatten([for i in 0..<rows: [for k in 0..<around: hole(i, k)]])
face shade = face(sheet, holes, space = "uv") with (color = "ivory")

let open = [for h in holes: area(face(sheet, [reversed(h)], space = "uv"))]
print area(sheet), sum(open) / area(sheet)
check area(shade) + sum(open) ~= area(sheet) within 1e-6
check len(shade.loops) == len(holes) + 2 "each hole is a loop of its own, beside both rims"
check sum(open) / area(sheet) < 0.5 "more sheet than holes"

export shade to "lampshade.step"
export shade to "lampshade.stl" with (tolerance = 0.2)
