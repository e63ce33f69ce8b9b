let a = 0x10
let b = !true
let c = 3"
param p = 3 between 1..5
let d = 0b101 + 0o17
