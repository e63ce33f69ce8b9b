geo 1
unit in
check 1 == 25.4mm
check norm((3, 4)) == 5in
check line((0, 0), (1in, 0)).end == (1, 0)
print 2.54cm, 1ft
