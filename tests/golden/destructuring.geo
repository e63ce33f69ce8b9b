let [a, b, c] = [1, (2, 3), "x"]
let {x, y} = { y: 2, x: 1, z: 0 }
print a, b, c, x, y
check a == 1 and b == (2, 3) and c == "x"
check x == 1 and y == 2
let local = { let [p, q] = [10, 20] p + q }
check local == 30
