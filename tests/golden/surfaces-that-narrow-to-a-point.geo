// Surfaces that narrow to a point fall apart there, as both sides only touch in it.
geo 1

fn areas(parts) = sort([for part in parts: area(part) / 1mm^2])
surface horn = torus((0, 0), 1, 1)
let half = 2 * pi^2
check areas(split(horn, by = XY)) ~= [half, half] within 1e-9
check areas(split(horn, by = plane((0, 0, 0), (0.1, 0.2, 1)))) ~= [half, half] within 1e-6
check areas(split(horn, by = plane((0, 0, 0), (1, 0, 0)))) ~= [half, half] within 1e-9
check area(trim(horn, by = XY, keep = "above")) ~= half within 1e-9
// The same with the point on its seam, and with a hole within the tolerance.
surface turned = revolve(rotate(circle((1, 0), 1), 180deg, about = (1, 0)), axis = (0, 1, 0))
check areas(split(turned, by = plane((0, 0, 0), (0, 1, 0)))) ~= [half, half] within 1e-9
check areas(split(torus((0, 0), 1, 0.9999995), by = XY)) ~= [half, half] within 1e-4

surface cones = revolve(polyline((1, 0, 0), (0, 0, 1), (1, 0, 2)))
let nappe = pi * sqrt(2)
check areas(split(cones, by = plane((0, 0, 1), (0, 0, 1)))) ~= [nappe, nappe] within 1e-9
check area(trim(cones, by = plane((0, 0, 1), (0.2, 0.1, 1)), keep = "below")) ~= nappe within 1e-9
check areas(split(cones, by = sphere((0, 0, 1.5), 0.5))) ~= [nappe / 4, 0.75 * nappe, nappe] within 1e-9
check areas(split(cones, by = plane_patch((-2, -2, 1), (4, 0, 0), (0, 4, 0)))) ~= [nappe, nappe] within 1e-9
// Smooth along the axis.
surface hourglass = revolve(bezier((1, 0, -1), (-1, 0, 0), (1, 0, 1)))
let waist = areas(split(hourglass, by = XY))
check len(waist) == 2 and waist[0] ~= waist[1] within 1e-9
// A plane along the axis parts each side of the cones in two.
check areas(split(cones, by = plane((0, 0, 1), (1, 0, 0)))) ~= [nappe / 2, nappe / 2, nappe / 2, nappe / 2] within 1e-9
