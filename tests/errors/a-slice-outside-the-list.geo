let xs = [1, 2, 3]
print xs[10..5]
print xs[1..3]
print xs[3..<3]
