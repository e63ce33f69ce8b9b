let a = 1e308 * 10
let b = exp(1000)
let c = 10^400
let d = 1e309
let e = (1e308, 0) * 10
