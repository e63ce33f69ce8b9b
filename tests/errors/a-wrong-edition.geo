geo 7
print 1
