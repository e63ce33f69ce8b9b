let d = 1/0
print d, 2, "three"
print 1/0, 5
print unknown_name, 6
print 7
