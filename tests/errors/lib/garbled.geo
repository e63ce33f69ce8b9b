let pi = = 3
let a = 2 * pi
let b = 1
