param r
curve c = circle((0, 0), r)
let x
