let data = {pts: [[1, 2], [3, 4]], at: [1, 2]}
print data.pts[0].x
print polyline(data.pts)
print contours(sphere((0, 0), 1), (0, 0, 1), 0.5)
let biggest = max(_, 3) + 1
