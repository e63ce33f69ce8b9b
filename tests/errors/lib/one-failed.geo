let good = 3
let bad = sqrt("x")
