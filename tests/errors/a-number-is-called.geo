let xs = [1, 2]
let a = 3
print a(2), xs(0), "f"
print "f"(1)
