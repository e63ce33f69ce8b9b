let a = 2
let b = if a == 2 then 1
print b
