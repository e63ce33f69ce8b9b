let good = 3
let bad = sqrt("x")
curve c = line((0, 0), (1, 0))
fn twice(x) = 2 * x
fn worse(x) = x + bad
let further = bad + 1
