let xs = [10, 20, 30]
check xs[0] == 10 and xs[2] == 30 and xs[-1] == 30 and xs[-3] == 10
check xs[1..2] == [20, 30] and xs[1..<2] == [20] and xs[0..-1] == xs and xs[1..0] == []
check [[1, 2], [3, 4]][1][0] == 3
check [...xs, 40, ...[]] == [10, 20, 30, 40]
check [] == [] and [1] != [1, 1] "lists of unequal length are not equal"
check len(xs) == 3
