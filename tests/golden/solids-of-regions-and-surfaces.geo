geo 1
unit m

// Prisms: the area times the height, whichever way they lean.
region plate = region(polyline([(0, 0), (4, 0), (4, 2), (0, 2)], closed = true), holes = [circle((1, 1), 0.5)])
solid bracket = extrude(plate, (0, 0, 0.3))
print bracket
check volume(bracket) ~= 0.3*(8 - pi/4)
check area(bracket) ~= 2*(8 - pi/4) + 0.3*(12 + pi)
check volume(extrude(plate, (1, 2, -0.3))) ~= volume(bracket)

// Pappus and Guldin: the area times the way of its centroid.
region ring = region(circle((3, 0), 1), holes = [circle((3, 0), 0.5)])
solid pipe = revolve(ring, axis = (0, 1, 0))
solid bend = revolve(ring, axis = (0, 1, 0), angle = -90deg)
print pipe, bend
check volume(pipe) ~= tau*3*pi*0.75
check volume(bend) ~= volume(pipe)/4
check [len(pipe.shells), len(bend.shells)] == [2, 1]
solid cone = revolve(region(polyline([(0, 0), (2, 0), (0, 0, 3)], closed = true)))
check volume(cone) ~= 4*pi and centroid(cone) ~= (0, 0, 0.75)

// Surfaces and faces that close, with or without caps.
solid tin = solid(cylinder((0, 0), 1, 3), cap = true)
solid tube = solid([cylinder((0, 0), 2, 3), cylinder((0, 0), 1, 3)], cap = true)
solid hollow = solid([sphere((0, 0), 2), sphere((0, 0), 1)])
solid dome = solid(trim(sphere((0, 0), 2), by = plane((0, 0, 1), (0, 0, 1)), keep = "above"), cap = true)
print tin, tube, hollow, dome
check volume(tin) ~= 3*pi and volume(tube) ~= 9*pi and volume(hollow) ~= 28/3*pi
check volume(dome) ~= 5/3*pi within 1e-7
check solid(tin) == tin

// They move, face outward in a mirror too, and have one closed mesh.
solids moved = [tin, tube] |> mirror(XY) |> scale(2)
check [for s in moved: volume(s)] ~= [24*pi, 72*pi]
fn shape(s) = check_mesh(tessellate(s, tolerance = 0.01))
let for_all = [for s in [bracket, pipe, bend, cone, tin, tube, hollow, dome]: shape(s)]
check every([for c in for_all: c.closed and c.manifold and c.oriented])
print [for c in for_all: c.euler]
export tin to "tin.stl" with (tolerance = 0.5, angle = 90deg, binary = false)
export cone to "cone.step"
export tin to "tin.json"
