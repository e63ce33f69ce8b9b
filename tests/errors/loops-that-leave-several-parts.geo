geo 1
let plate = plane_patch((-3, -3), (6, 0), (0, 6))
print face(plate, [circle((-1, 0), 1), circle((1, 0), 1)])
print face(plate, [polyline([(-2, -2), (2, -2), (2, 2), (-2, 2)], closed = true), circle((0, 0), 1)])
print face(plate, [polyline([(-2, -2), (2, -2), (2, 2), (-2, 2)], closed = true), polyline([(-2, 0), (-2, 1), (-1, 1), (-1, 0)], closed = true)])
