// The half of a pipe on the side of its seam consists of two islands in the plane of its parameters. A second cut runs
// over the whole surface, between the islands as well, where it divides nothing.
geo 1

solid pipe = extrude(region(circle((0, 0), 2), holes = [circle((0, 0), 1)]), (0, 0, 5))

// Each half is cut at three fifths of its height, wherever the seam lies.
fn half(angle) = cut(pipe, plane((0, 0, 0), (cos(angle), sin(angle), 0)), keep = "above")
solids low = [for i in 0..11: cut(half(i * 30deg), plane((0, 0, 3), (0, 0, 1)))]
check [for s in low: volume(s)] ~= [for s in low: 4.5 * pi * 1mm^3] within 1e-11mm^3
check [for s in low: area(s)] ~= [for s in low: (9*pi + 3*pi + 6) * 1mm^2] within 1e-11mm^2
check [for s in low: check_mesh(tessellate(s)).closed] == [for s in low: true]
check area(section(half(0deg), plane((0, 0, 3), (0, 0, 1)))[0]) ~= 1.5 * pi * 1mm^2 within 1e-12mm^2

// Faces likewise, by planes and by curves.
surface wall = cylinder((0, 0), 1, 2)
face front = trim(wall, by = plane((0, 0, 0), (1, 0, 0)), keep = "above")
check area(trim(front, by = plane((0, 0, 1), (0, 0, 1)), keep = "above")) ~= pi * 1mm^2 within 1e-12mm^2
check [for f in split(front, by = circle((0, 0, 0.5), 1)): area(f)] ~= [1.5 * pi * 1mm^2, 0.5 * pi * 1mm^2] within 1e-11mm^2

// A slit divides nothing, and takes nothing away; two of them around a hole make two parts.
face ring = face(plane_patch((0, 0), (4, 0), (0, 4)), [reversed(circle((2, 2), 1))])
check [for f in split(ring, by = line((0, 2), (1, 2))): area(f)] ~= [(16 - pi) * 1mm^2] within 1e-12mm^2
check [for f in split(ring, by = [line((0, 2), (1, 2)), line((3, 2), (4, 2))]): area(f)] ~= [for i in 0..1: (8 - pi/2) * 1mm^2] within 1e-12mm^2
