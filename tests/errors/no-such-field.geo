let p = (1, 2)
curve c = bezier(p, (2, 2))
let r = { radius: 1, height: 2 }
let n = 5
print p.w, c.degre, r.hieght, n.x, [1].length
