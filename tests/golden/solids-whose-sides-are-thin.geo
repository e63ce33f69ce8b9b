// Slabs of ten tolerances have edges that are found at their corners too.
geo 1
check volume(solid(box((0, 0, 0), (1, 1, 1e-5)))) ~= 1e-5 within 1e-15
check volume(solid(box((0, 0, 0), (1, 1, 3e-5)))) ~= 3e-5 within 1e-15

// Of faces through which hardly anything flows the volume is known as well as of others.
let prism = extrude(region(polyline([(0, 0), (1, 0), (0, 1)], closed = true)), (0, 0, 1))
check volume(cut(prism, plane((0, 0, 0.5), (0, 0, 1)))) ~= 0.25 within 1e-9
let cube = solid(box((0, 0, 0), (1, 1, 1)))
check volume(cut(cube, plane((0.5, 0.5, 0.5), (1, 2, 3)))) ~= 0.5 within 1e-9
let halves = [
    for r in [0.55, 0.75, 2, 2.08]:
        volume(cut(solid(sphere((0, 0, 0), r)), plane((0, 0, 0), (1, 1, 0)))) / r^3
]
check every(halves, v => abs(v - 2 / 3 * pi) < 1e-8)

// Shells apart by a thousandth of their size and less.
check volume(solid([sphere((0, 0, 0), 1), rotate(sphere((0, 0, 0), 0.999), 33deg, axis = (1, 2, 3))])) ~= 4/3*pi*(1 - 0.999^3) within 1e-9
check volume(solid([torus((0, 0, 0), 3, 1), torus((0, 0, 0), 3, 0.9999)])) ~= 6*pi^2*(1 - 0.9999^2) within 1e-9
check intersect(sphere((0, 0, 0), 1), sphere((0, 0, 0), 0.9999)) == []
check intersect(cylinder((0, 0, 0), 1, 3), cylinder((0, 0, 0), 0.9999, 3)) == []
