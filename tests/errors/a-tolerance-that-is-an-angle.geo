tolerance 3deg
print 1 == 1.00001
