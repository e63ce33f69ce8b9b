let root = 1 / 0
let b = root + 1
curve c = circle((0, 0), b)
print length(c), root
check b > 0
export c to "c.json"
fn f(x) = x + b
let d = f(2)
