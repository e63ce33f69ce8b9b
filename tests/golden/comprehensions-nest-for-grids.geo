let grid = [for i in 0..2: [for j in 0..1: (i, j)]]
check grid[2][1] == (2, 1) and len(grid) == 3
check sum([for i in 0..3, j in 0..3 if i != j: 1]) == 12
check [for i in 0..4 if i % 2 == 0, j in 0..<i: j] == [0, 1, 0, 1, 2, 3]
check [for [a, b] in [[1, 2], [3, 4]]: a * b] == [2, 12]
check [for {x, y} in [{x: 1, y: 2}]: x + y] == [3]
check [for p in [(1, 2)]: p.y] == [2]
surface s = bezier(grid)
check s.degree_u == 2 and s.degree_v == 1
