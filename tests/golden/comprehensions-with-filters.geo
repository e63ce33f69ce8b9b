let pairs = [for i in 0..3, j in 0..3 if i != j: (i, j)]
print pairs
check len(pairs) == 12
check pairs[0] == (0, 1)
check [for i in 1..10 if i % 3 == 0: i^2] == [9, 36, 81]
check [for i in 0..2, j in 0..i: 10*i + j] == [0, 10, 11, 20, 21, 22] "a later variable sees the earlier"
let grid = [for i in 0..2: [for j in 0..1: (i, j, i*j)]]
check len(grid) == 3 and len(grid[0]) == 2
check grid[2][1] == (2, 1, 2)
check [for p in [(1, 2), (3, 4)]: p.x + p.y] == [3, 7]
check [for word in ["a", "b"]: "{word}!"] == ["a!", "b!"]
check [for i in []: i] == []
