let p = rotate((1, 0), 90)
let q = polar(1, 45)
