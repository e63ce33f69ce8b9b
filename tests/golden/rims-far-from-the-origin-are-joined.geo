// Rounding leaves spans of parameters at the seam of which a rim has no use.
let far = 10549.2
solid ring = translate(solid(torus((0, 0, 0), 2, 1)), (far, 0, 0))
let across = plane((far, 0, 0.3), (0.3, 0.2, 1))
let [disc] = section(ring, across)
print disc
check area(disc) ~= 19.6110660595mm^2 within 1e-8mm^2
