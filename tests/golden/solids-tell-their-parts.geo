geo 1
unit mm

// The prism over an L has one edge that goes in.
solid notched = extrude(region(polyline([(0, 0), (4, 0), (4, 1), (1, 1), (1, 3), (0, 3)], closed = true)), (0, 0, 2))
let told = [for e in edges(notched): report(e)]
check len(told) == 18 and len(filter(told, t => t.convex)) == 17
check [for t in told if not t.convex: t.angle] ~= [270deg]
check sum([for t in told: t.length]) ~= 2*14 + 6*2
check every([for t in told: len(t.faces) == 2 and t.deviation <= 1e-12])
let whole = report(notched)
check whole.least_angle ~= 90deg and whole.deviation <= 1e-12 and whole.welded <= 1e-12
check len(faces(notched)) == whole.faces and len(vertices(notched)) == whole.vertices
check faces(notched) == notched.faces and vertices(notched) == notched.vertices

// The sharpest angle of a triangle with legs of 3 and 4; of a cone with half an angle of 45deg along its rim.
solid wedge = extrude(region(polyline([(0, 0), (4, 0), (0, 3)], closed = true)), (0, 0, 1))
check report(wedge).least_angle ~= atan(3/4)
check report(solid(cone((0, 0), 2, 0, 2), cap = true)).least_angle ~= 45deg within 1e-6deg

// A ball in a shell: two bodies.
solid nested = solid([sphere((0, 0), 3), sphere((0, 0), 2), sphere((0, 0), 1)])
let parts = bodies(nested)
check len(shells(nested)) == 3 and [for p in parts: len(shells(p))] == [2, 1]
check [for p in parts: volume(p)] ~= [4/3*pi*19, 4/3*pi]

// Halves of a ball go on in one another; a ball goes on in a tube of its radius with another bend; a lid does not.
faces halves = split(sphere((0, 0), 2), by = XY)
check continuity(halves[0], halves[1]).g == 2
face cap = trim(sphere((0, 0), 2), by = XY, keep = "above")
let joint = continuity(cap, face(cylinder((0, 0, -3), 2, 3)))
check joint.g == 1 and joint.curvature_gap ~= 0.5 within 1e-6
check continuity(cap, face(region(circle((0, 0), 2)))).angle ~= 90deg within 1e-6deg

// Beside half a ball by 0.5, and within it.
check [for d in [0.5, -0.5]: area(offset(cap, d))] ~= [for d in [0.5, -0.5]: 2*pi*(2 + d)^2]
check length(offset(cap, 0.5)) ~= tau*2.5 within 1e-6
// A pane beside a crease has an offset where the whole surface has none.
surface roof = bspline([[(0, 0), (0, 1)], [(1, 0, 1), (1, 1, 1)], [(2, 0), (2, 1)]], degree = 1)
face pane = face(roof, [polyline([(0.1, 0.1), (0.4, 0.1), (0.4, 0.9), (0.1, 0.9)], closed = true)], space = "uv")
check area(offset(pane, 0.3)) ~= area(pane)
print told[0].kind, whole.genus, joint.gap, offset(pane, 0.3)
