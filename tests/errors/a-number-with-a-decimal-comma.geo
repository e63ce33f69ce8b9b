let a = 3
print a(2)
print num("3,5")
print num("three")
