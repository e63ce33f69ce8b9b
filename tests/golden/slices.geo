let xs = [10, 11, 12, 13, 14]
print xs[1..3], xs[1..<3], xs[0..-1], xs[-2..-1], xs[3..1]
check xs[0] == 10
check xs[-1] == 14
check xs[1..3] == [11, 12, 13] "b is included"
check xs[1..<3] == [11, 12]
check xs[0..-1] == xs
check xs[-2..-1] == [13, 14]
check xs[3..1] == [] "an empty range is an empty slice"
check xs[0..<0] == []
check xs[5..<5] == []
