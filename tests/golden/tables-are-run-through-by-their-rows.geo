let t = table([{name: "bow", x: 1, h: 2m}, {name: "stern", x: 3, h: 40cm}])
print [for row in t: row.h]
print [for row in t if row.x > 2: row.name]
check [...t][1] == t[1] and len([...t, t[0]]) == 3
check [for row in t, k in 1..2: row.x * k] == [1, 2, 3, 6]
check every([...t], row => row.x < 9)
// A table that the script calls `all` is that.
table all = t
export all to "all.csv"
print table([for row in t: {name: row.name, twice: 2 * row.x, thrice: 3 * row.x, height: row.h, square: row.x^2, cube: row.x^3}])
// Conditions in a comprehension.
let radii = minimize(u => sum(u), start = [5, 5, 5], subject = u => [for k in 0..2: u[k] >= k + 1])
check radii ~= [1, 2, 3] within 1e-6
check minimize(u => u[0] + u[1], start = [4, 4], subject = u => [...[for r in u: r >= 1], u[0] >= 2 * u[1]]) ~= [2, 1] within 1e-6
