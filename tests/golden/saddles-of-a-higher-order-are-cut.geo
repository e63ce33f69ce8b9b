// Saddles that are flat where the curves in their plane cross: no loops are left of the place.
geo 1

// The Bézier points of x, x^2 and x^3 over -1..1.
let [one, two, three] = [[-1, -1/3, 1/3, 1], [1, -1/3, -1/3, 1], [-1, 1, -1, 1]]
fn over(f) = bezier([for i in 0..3: [for j in 0..3: (one[i], one[j], f(i, j))]])
fn lengths(s) = sort([for q in section(s, XY): length(q) / 1mm])

check lengths(over((i, j) => three[i] - three[j])) ~= [2 * sqrt(2)] within 1e-6
let monkey = over((i, j) => three[i] - 3 * one[i] * two[j])
let side = sqrt(4 / 3)
check lengths(monkey) ~= [1, 1, side, side, side, side] within 1e-6
check len(split(monkey, by = XY)) == 6
check lengths(over((i, j) => two[i] * one[j])) ~= [1, 1, 1, 1] within 1e-6
