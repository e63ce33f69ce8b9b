check every([1, 2, -3, 4], x => x > 0)
check every([for i in 0..3: line((0, 0), (i + 1, 0))], c => length(c) < 3)
check not every([1, 2], x => x > 0)
