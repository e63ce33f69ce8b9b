// Linkeová: from Coons points to Bezier points and back ((2.49), (2.51))
geo 1
let ones = [for i in 0..3: [for j in 0..3: if i == j then (1, 0) else (0, 0)]]
let to_bezier_points = transpose([for e in ones: [for p in decompose(coons_cubic(e))[0].points: p.x]])
check to_bezier_points ~= [[1/6, 2/3, 1/6, 0], [0, 2/3, 1/3, 0], [0, 1/3, 2/3, 0], [0, 1/6, 2/3, 1/6]] within 1e-12
let to_coons_points = transpose([for e in ones: [for p in to_coons(bezier(e)).points: p.x]])
check to_coons_points ~= [[6, -7, 2, 0], [0, 2, -1, 0], [0, -1, 2, 0], [0, 2, -7, 6]] within 7e-12
