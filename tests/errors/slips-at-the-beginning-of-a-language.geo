curve = line((0, 0), (1, 0))
let my-name = 3
let list = "set {1,2}"
check 3 == 3 ok
fn f(x) = { return x + 1 }
let decimal = 3,5
