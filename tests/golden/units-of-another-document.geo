unit in
check 25.4mm ~= 1
check 1ft ~= 12
check (2.54cm, 0).x ~= 1
print 1in, 25.4mm
