// Cuts that miss a pole, a tip, a common axis or a touch by less than the tolerance.
geo 1
unit mm
tolerance 1e-6

let ball = sphere((0, 0), 1)
let misses = [1e-6, 3e-7, 1e-7, 1e-8, 1e-10, 1e-12]
fn areas(faces) = sum([for f in faces: area(f)]) / 1mm^2

// A plane beside both poles, and beside the tip of a cone: caps, and halves.
fn below(d) = trim(ball, by = plane((d, 0, 0), (1, 0, 0)), keep = "below")
check every(misses, f = d => areas([below(d)]) ~= 2 * pi * (1 + d) within 1e-11)
fn half(d) = trim(cone((0, 0), 1, 0, 2), by = plane((d, 0, 0), (1, 0, 0)), keep = "below")
check every(misses, f = d => areas([half(d)]) ~= sqrt(5) * (pi / 2 + 2 * d) within 1e-11)

// Spheres of one radius cross in a circle in the middle, however near their centres are.
fn shared(centre) = trim(ball, by = solid(sphere(centre, 1)), keep = "inside")
check areas([shared((1e-3, 2e-3, -1e-3))]) ~= 2 * pi * (1 - sqrt(6) * 5e-4) within 1e-11
check areas([shared((1e-4, 0, 0))]) ~= 2 * pi * (1 - 5e-5) within 1e-11
check areas([shared((1e-7, 0, 1))]) ~= pi within 1e-11
fn wall(d) = solid(cylinder((0.7 + d, 0, -3), 0.7, 6), cap = true)
check areas(split(ball, by = wall(1e-7))) ~= 4 * pi within 1e-11

// An axis that all but goes through the centre, or is another one.
fn ring(d) = trim(ball, by = solid(cylinder((d, 0, -3), 0.6, 6), cap = true), keep = "outside")
check every(misses, f = d => areas([ring(d)]) ~= 4 * pi * 0.8 within 1e-10)
fn rim(d) = intersect(cone((0, 0), 1, 0, 2), cylinder((d, 0, -1), 0.5, 4))
check every(misses, f = d => length(rim(d)[0]) / 1mm ~= pi within 1e-6)

// Surfaces about one axis that touch, or all but do, share one circle; a tip that all but touches a place.
print [for c in intersect(ball, cylinder((0, 0, -3), 1 - 1e-7, 6)): length(c)]
print [for c in intersect(ball, cylinder((0, 0, -3), 1 + 1e-7, 6)): length(c)]
print [for c in intersect(torus((0, 0), 3, 1), sphere((0, 0), 2 + 1e-7)): length(c)]
print [for c in intersect(torus((0, 0), 3, 1), torus((0, 0, 2 - 1e-7), 3, 1)): length(c)]
print intersect(ball, cone((0, 0, 1 - 1e-7), 0, 1, 2))

// All of a circle is nearly as near to what is beside its centre: one place, not one for each part.
fn foot(d) = closest(circle((0, 0), 1), (d, 0, 0.3))
check every(misses, f = d => foot(d).count == 1)
check every(misses, f = d => foot(d).distance / 1mm ~= hypot(1 - d, 0.3) within 1e-12)
