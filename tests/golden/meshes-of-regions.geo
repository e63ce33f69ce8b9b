// Plane regions within closed curves, with holes.

mesh plate = planar_mesh([circle((0, 0), 5), circle((2, 0), 1), reversed(circle((-2, 0), 1)), circle((0, 3), 0.5)], tolerance = 1e-4)
check area(plate) ~= (25 - 1 - 1 - 0.25)*pi within 0.01
print check_mesh(plate).closed
// An L, with its normals on the side from which it runs counter-clockwise.
mesh corner = planar_mesh(polyline([(0, 0, 1), (3, 0, 1), (3, 1, 1), (1, 1, 1), (1, 3, 1), (0, 3, 1)], closed = true))
print area(corner), corner.normals[0], len(corner.triangles)
mesh turned = planar_mesh(reversed(polyline([(0, 0), (1, 0), (1, 1)], closed = true)))
print turned.normals[0]
// A star in a plane that is askew.
let askew = frame_of((1, 2, 3), (1, 1, 0), (0, 1, 1))
mesh star = planar_mesh(place(polyline([for i in 0..<10: polar(if i % 2 == 0 then 3 else 1, 36deg*i)], closed = true), askew))
check area(star) ~= 15*sin(36deg) 
print len(star.triangles)
