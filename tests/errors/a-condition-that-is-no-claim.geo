let a = if 1 then 2 else 3
let b = 1 and true
let c = not 3
let d = [for i in 0..3 if i: i]
