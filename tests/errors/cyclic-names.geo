let a = b + 1
let b = c * 2
let c = a - 1
let alone = alone + 1
print a
