print 0..3, 0..<3, 0.5..2
check [for i in 0..3: i] == [0, 1, 2, 3]
check [for i in 0..<3: i] == [0, 1, 2]
check [for i in 3..1: i] == [] "3..1 is empty"
check [for i in -1..1: i] == [-1, 0, 1]
check [for i in 2..2: i] == [2]
check sum(1..100) == 5050 "a range of whole numbers is as good as their list"
let r = 0.5..2
check r.start == 0.5 and r.end == 2
let n = 3
check [for i in 0..n-1: i] == [0, 1, 2] "sums bind tighter"
check range(0, 1, 0.25) == [0, 0.25, 0.5, 0.75, 1]
check range(0, 1, 0.3) ~= [0, 0.3, 0.6, 0.9]
check len(range(0, 1, 0.1)) == 11 "the end is included when it is reached"
check linspace(0, 1, 5) == [0, 0.25, 0.5, 0.75, 1]
check first(cosspace(0, 2, 5)) == 0 and last(cosspace(0, 2, 5)) == 2
check cosspace(0, 1, 3)[1] ~= 0.5
check curve_domain.end == 1
let curve_domain = bezier((0, 0), (1, 1)).domain
print curve_domain
