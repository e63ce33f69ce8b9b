curve c = circle((0, 0))
fn f(a, b) = a + b
let x = f(1)
let y = f(1, 2, 3)
