print 5.x
