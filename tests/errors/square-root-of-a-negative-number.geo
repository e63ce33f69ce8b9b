let a = sqrt(-1)
let b = ln(0)
let c = asin(2)
let d = (-8)^(1/3)
