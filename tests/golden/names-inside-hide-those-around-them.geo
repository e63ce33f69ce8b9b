// Parameters, variables of comprehensions and names of blocks and tests may hide names of around them.
fn half(n) = n / 2
fn shape(r) = circle((0, 0), r)
let r = 5
let n = 10
check half(n + 2) == 6 and half(3) == 1.5
check length(shape(2)) ~= 4 * pi and length(shape(r)) ~= 10 * pi
check [for n in 0..3: n * r] == [0, 5, 10, 15] and n == 10
check [for n in 1..3: [for n in 1..n: n]] == [[1], [1, 2], [1, 2, 3]]
check map([1, 2], n => n + r) == [6, 7]

// A block's own name stands in all of the block, and outside of it not.
let block = {
    let a = n + 1
    let n = 2
    fn r(x) = x * n
    [a, r(4), { let n = 7; r(n) }, n]
}
check block == [3, 8, 14, 2] and n == 10 and r == 5

// What a function took from around it stays what it was where it was made.
fn nested(n) = {
    let outer = () => n
    let inner = { let n = n_of(1); [outer(), n, (n => n + outer())(100)] }
    fn n_of(k) = k + 40;
    [...inner, n]
}
check nested(3) == [3, 41, 103, 3]
// A variable does not count as a use of the block's name: this is no circle.
check { let f = x => x * 2; let x = f(3); x } == 6
check { let all = [for [x, y] in [[1, 2]], k in 0..x: x + y + k]; let x = all[0]; let y = all[1]; [x, y] } == [3, 4]
check { fn f(x, y = x) = x + y; let y = f(2); let x = f(3, y = y); [x, y] } == [7, 4]
// A definition of the file may use its own name inside.
let twice = { let twice = 2; twice * 3 }
check twice == 6
fn factorial(factorial) = if factorial < 2 then 1 else factorial * other(factorial - 1)
fn other(k) = factorial(k)
check factorial(5) == 120

test "names of a test hide those of the file" {
    let r = n * 2
    let n = 4
    check r == 8 and half(n) == 2
}
