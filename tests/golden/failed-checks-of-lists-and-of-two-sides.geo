let x = 3
let rows = [{name: "a", r: 2}, {name: "b", r: -2}]
check x < 1 or x > 5
check [1, 2, 3] == [1, 2, 4]
check {a: 1, b: [1, 2]} == {a: 1, b: [1, 3]}
check [1, 2] == [1, 2, 3]
check every(rows, row => row.r > 0)
check x == 4 or (x > 2 and x > 5)
check 0.1 + 0.2 == 0.3
check 0.1 == 0.3
