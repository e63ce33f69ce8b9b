print 7 % 3, -7 % 3, 7 % -3, -7 % -3, 6 % 3, -6 % 3
check 7 % 3 == 1
check (-7) % 3 == 2
check 7 % -3 == -2
check (-7) % -3 == -1
check -6 % 3 == 0
check 5.5 % 2 == 1.5
check (-370deg) % 360deg ~= 350deg
