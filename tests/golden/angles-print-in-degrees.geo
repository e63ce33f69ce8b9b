print 90deg, 0.25turn, 1rad, asin(1), atan2(1, -1), angle_between((1, 0), (0, 1)), 45deg + 45deg
check 180deg ~= pi "against an angle a bare number is radians"
check 1turn == 360deg
check sin(30deg) ~= 0.5
check cos(60deg) ~= 0.5
check tan(45deg) ~= 1
check sin(pi / 2) ~= 1 "trigonometry takes bare numbers as radians"
check asin(0.5) ~= 30deg
check acos(0) ~= 90deg
check atan(1) ~= 45deg
check atan2(1, -1) ~= 135deg
check polar(2, 90deg) ~= (0, 2)
check 90deg / 45deg == 2
check rotate((1, 0), 90deg) ~= (0, 1)
check rotate((1, 0), 90deg, about = (1, 1)) ~= (2, 1)
