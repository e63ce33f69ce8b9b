// A part of a surface with a crease has edges with corners on it, and is meshed as any other.
surface folded = extrude(polyline((-2, 0, 0), (-0.5, 0, 1), (1, 0, 0.2), (2, 0, 0)), (0, 4, 0))
faces parts = split(folded, by = cylinder((0.3, 2, -5), 1, 10))
check sum([for f in parts: area(f)]) ~= area(folded) within 1e-12
// Over a disc the area is that of it, stretched by the slope of each plane: between x = 1 and 1.3, and left of x = -0.5.
fn beyond(x) = acos(x) / 1rad - x * sqrt(1 - x^2)
let [steep, middle, flat] = [sqrt(1 + (1/1.5)^2), sqrt(1 + (0.8/1.5)^2), sqrt(1 + 0.2^2)]
let left = beyond(0.8)
let right = beyond(0.7)
let disc = left * steep + (pi - left - right) * middle + right * flat
let inner = argmin([for f in parts: area(f)])
check area(parts[inner]) ~= disc within 1e-11
let near = [for f in parts: tessellate(f, tolerance = 0.003)]
check every([for i in 0..1: abs(area(near[i]) - area(parts[i])) < 0.01 * area(parts[i])])
// The waist of a body of revolution, cut by a cylinder through it.
surface waist = revolve(polyline((0, 0, -2), (2, 0, -1), (1, 0, 0), (2, 0, 1), (0, 0, 2)))
let cuts = [for r in [0.6, 0.7]: split(waist, by = cylinder((-6, 0, 0), r, 12, axis = (1, 0, 0)))]
check every([for c in cuts: sum([for f in c: area(f)]) ~= area(waist) within 1e-9])
check every([for c in cuts: sum([for f in c: area(tessellate(f, tolerance = 0.01))]) ~= area(waist) within 0.6])
// A cylinder along the axis: behind the waist the edges turn back by more than a right angle. The cylinder passes the waist
// in two places, where circles of radius 1 and 0.6 cross.
surface bore = cylinder((0.5, 0.3, -5), 0.6, 10)
let apart = sqrt(0.34)
let along = (1 - 0.36 + 0.34) / (2 * apart)
let across = sqrt(1 - along^2)
let towards = (0.5, 0.3, 0) / apart
let aside = (-0.3, 0.5, 0) / apart
curves through = intersect(waist, bore)
let at_waist = [for c in through if abs(c.start.z) < 0.5: c]
check len(through) == 3 and len(at_waist) == 1
check every([for way in [1, -1]: closest(at_waist[0], (0, 0, 0) + along * towards + way * across * aside).distance < 1e-12])
let bored = split(waist, by = bore)
check len(bored) == 4 and sum([for f in bored: area(f)]) ~= area(waist) within 1e-9
check sum([for f in bored: area(tessellate(f, tolerance = 0.01))]) ~= area(waist) within 0.6
