// The first operation through which no derivative passes is named, and why.
print gradient(p => length(offset(bezier((0, 0), p, (4, 0)), 0.1)), (2, 1))
print gradient(h => volume(tessellate(box((0, 0), (1, 1, h)))), 2)
// How parameters by Foley's rule move is not known; listed ones do not.
print gradient(h => length(interpolate((0, 0), (1, h), (3, 0), (4, 1), parameters = "foley")), 1)
print gradient(h => length(interpolate((0, 0), (1, h), (3, 0), (4, 1), parameters = [0, 1, 2, 3])), 1)
// A leg of no length grows to both sides.
print gradient(h => length(polyline((0, 0), (1, 0), (1, h))), 0)
print gradient(h => length(parametric(t => (t, h * t), 0..1)), 1)
print gradient(k => bezier((0, 0), (1, 2), (2, 0)).points[k].x, 1)
let made = h => bezier((0, 0), (1, h), (2, 0))
print gradient(h => length(parametric(t => made(h)(t), 0..1)), 1)
// Cut where it grows: the cut moves along a bend.
print gradient(t => trim(bezier((0, 0), (1, 2), (2, 0)), 0..t).end.y, 0.5)
// A lid that leaves its box holds nothing.
fn lidded(h) = { let sides = box((0, 0), (1, 1, 1))
  [for i in 0..5: if i == 5 then translate(sides[i], (0, 0, h)) else sides[i]] }
print gradient(h => volume(lidded(h)), 0)
