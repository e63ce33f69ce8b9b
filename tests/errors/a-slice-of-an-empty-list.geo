let xs = []
print xs[1..-1]
