let a = 2
check a = 2
let b = if a = 2 then 1 else 0
