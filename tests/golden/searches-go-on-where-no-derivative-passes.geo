// Regions in a list carry no derivatives on; `solve` from a start and `minimize` take differences then.
let plate = region(circle((0, 0), 3))
let left = u => area(difference(plate, [region(circle((0, 0), u.r))])[0]) - 20mm^2
let found = solve(left, start = {r: 1})
check found.r ~= sqrt(9 - 20 / pi) within 1e-7
print found.r ~= 1.6228993 within 1e-6
