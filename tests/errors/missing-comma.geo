let ps = [(0, 0) (1, 2), (2, 0)]
let xs = [1 2, 3]
curve c = circle((0, 0) 2)
