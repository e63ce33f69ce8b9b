unit mm
// A region goes along a path, with its holes, and ends as it stands there.
fn across(radius) = circle((0, 0), radius, normal = (1, 0, 0))
region ring = region(across(1), holes = [across(0.5)])
solid straight = sweep(ring, line((0, 0), (5, 0)))
check volume(straight) ~= 3.75*pi and genus(straight) == 1
solid bent = sweep(ring, bezier((0, 0, 0), (6, 0, 0), (6, 6, 0), (6, 6, 6)), tolerance = 1e-4)
// Pappus: the centre goes along the path.
check volume(bent) ~= area(ring) * length(bezier((0, 0, 0), (6, 0, 0), (6, 6, 0), (6, 6, 6))) within 1e-2
check volume(sweep(ring, circle((0, 0), 4))) ~= area(ring) * 8mm * pi
region square = region(polyline((0, -1, -1), (0, 1, -1), (0, 1, 1), (0, -1, 1), closed = true))
check volume(sweep(square, polyline((0, 0), (5, 0), (5, 5)), corner = "miter")) ~= 40
check volume(sweep(square, line((0, 0), (5, 0)), twist = 90deg, scale = [1, 0.5])) ~= 20 * 7/12 within 1e-4
print bent, sweep(ring, circle((0, 0), 4))

// Through regions, holes in their order.
region base = region(polyline((-2, -2), (2, -2), (2, 2), (-2, 2), closed = true), holes = [circle((0, 0), 1)])
region neck = region(circle((0, 0, 5), 1), holes = [circle((0, 0, 5), 0.7)])
solid funnel = skin([base, neck])
print funnel, genus(funnel)
check check_mesh(tessellate(funnel, tolerance = 0.1)).closed
check volume(skin([for z in 0..3: region(circle((0, 0, z), 2), holes = [circle((0, 0, z), 1)])])) ~= 9*pi
let around = [for i in 0..<8: rotate(translate(square, (0, 6, 0)), i * 45deg, axis = (0, 0, 1))]
print skin(around, closed = true)
