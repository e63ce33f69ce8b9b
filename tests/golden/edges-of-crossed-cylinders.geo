// Where two cylinders of one radius cross, the four faces of what both hold meet along quarters of ellipses.
unit mm
surface a = cylinder((0, 0, -2), 1, 4)
surface b = cylinder((-2, 0, 0), 1, 4, axis = (1, 0, 0))
let upright = filter(split(a, by = b), f => abs(centroid(f).z) < 0.1)
let level = filter(split(b, by = a), f => abs(centroid(f).x) < 0.1)
solid both = solid([...upright, ...level])
let all = edges(both)
check abs(volume(both) - 16/3 * 1mm^3) < 1e-9mm^3
// Half an ellipse of half axes 1 and the root of 2 is 3.820197789 long.
check abs(sum([for e in all: length(e)]) - 4 * 3.8201977890277mm) < 1e-6mm
check report(both).genus == 0
print len(all), len(vertices(both))
