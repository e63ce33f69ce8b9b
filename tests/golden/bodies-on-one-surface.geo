// Cuts that leave several bodies on one surface: whether one lies within another tells the face that is nearest, as an
// integral over a face that begins beside it passes through the place. Shells whose edges lie on one curve, one on each
// side of where that begins, do not meet.
geo 1

solid ring = solid(torus((0, 0, 0), 2, 0.8))
    |> cut(plane((0, 0, 0), (0.4989, -2.5530, -0.9769)), keep = "above")
    |> cut(plane((0, 0, 0), (-1.1595, -0.9282, -1.3460)), keep = "above")
    |> cut(plane((0.1465, -0.0458, -0.0760), (0.2604, 0.1809, -0.7574)), keep = "above")
check report(ring).bodies == 2

solid tube = extrude(region(circle((0, 0, -2), 2), holes = [circle((0.3, 0, -2), 1)]), (0.5, 0, 4))
    |> cut(plane((0.4087, -0.4972, -0.2490), (-0.0751, -0.4499, -0.8083)))
    |> cut(plane((-0.0032, -0.1990, -0.0579), (-1.1988, 0.0074, -0.3389)))
let tubes = [
    for side in ["below", "above"]:
        cut(tube, plane((0, 0, 0), (0.6664, 0.3551, 2.2517)), keep = side)
]
check sum([for t in tubes: volume(t)]) ~= volume(tube) within 1e-8mm^3
check [for t in tubes: report(t).bodies] == [2, 1]
