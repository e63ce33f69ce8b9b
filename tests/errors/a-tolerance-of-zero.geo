tolerance 0
print 1 == 1.00001
