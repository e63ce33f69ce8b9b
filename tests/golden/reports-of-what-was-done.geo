// A report belongs to the result of the operation that left it.
curve through = interpolate((0, 0), (3, 4), (6, 0), closed = false)
print report(through)
check report(through).parameters ~= [0, 0.5, 1]

// The offset of a circle is exact, that of a parabola keeps the tolerance.
let circular = report(offset(circle((0, 0), 2), 1))
let near = report(offset(bezier((0, 0), (1, 2), (2, 0)), 0.1))
check circular.deviation == 0
check 0 < near.deviation and near.deviation <= 1e-6

// Of a list, one each.
check [for r in report([through, through]): r.operation] == ["interpolate", "interpolate"]
// A receipt is no part of the geometry.
check offset(line((0, 0), (4, 0)), 1) == line((0, -1), (4, -1))
