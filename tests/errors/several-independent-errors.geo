let a = 1 / 0
let b = unknown_thing
let c = [1, 2][5]
curve d = "text"
print sqrt(-4)
check 1 == 1
