let f = lambda x: x
let a = 5 if true else 3
print f"value {3}"
print "a" "b"
fn area(r) = pi r^2
let b = 2pi
let part = [1, 2, 3][1:2]
let c = i++
let xs = [for i in 0..3 i*2]
