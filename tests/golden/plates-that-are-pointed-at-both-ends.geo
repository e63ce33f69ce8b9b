geo 1
unit m

// A waterplane: its area is twice that under a cubic, its centre in the middle, at whatever height it lies.
fn waterplane(z) = {
    let side = translate(bezier((-45, 0), (-20, 9), (20, 9), (45, 0)), (0, 0, z))
    ruled(side, mirror(side, ZX))
}
check every([0, 0.001, 0.5, 0.7, 4, 123.456], z => area(waterplane(z)) ~= 837m^2 within 1e-9m^2)
check every([0, 0.001, 0.5, 0.7, 4, 123.456], z => centroid(waterplane(z), of = "area") ~= (0, 0, z) within 1e-9)
let moments = inertia(waterplane(0.7), of = "area").moments
check moments[2] ~= moments[0] + moments[1] within 1e-6m^4

// The rim of what a plane leaves of a sphere.
face bowl = trim(sphere((0, 0), 1), by = plane((0, 0.5, 0), (0, -1, 0)), keep = "above")
check sum([for e in bowl.edges: length(e)]) ~= tau * sqrt(0.75) * 1m within 1e-6m
