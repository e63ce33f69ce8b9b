let c = circle((0, 0), 2)
let a = arrows(c, "normal", head = -0.1)
let b = arrows(c, "normal", head = 2)
let d = arrows(c, "normal", head = "big")
