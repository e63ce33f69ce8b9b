let xs = [1, 2,]
let p = (1, 2, 3,)
let r = {a: 1, b: 2,}
fn f(x, y = 2,) = x + y
let [a, b,] = xs
let {k1, k2,} = {k1: 1, k2: 2,}
print f(1,), f(1, y = 3,), xs, p, r, a, b, k1, k2,
check ((x, y,) => x + y)(1, 2) == 3
check [for i in 0..1, j in 0..1,: i + j] == [0, 1, 1, 2]
