let a = 3 $ 4
let b = true && false
let c = 'text'
let d = a ≥ 3
