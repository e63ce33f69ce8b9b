let [a, b, c] = [1, 2]
let {x, y} = { x: 1, z: 2 }
let [p, q] = 5
