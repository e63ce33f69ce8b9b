let x = 1 / 0
let y = 2
