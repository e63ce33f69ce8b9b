// A warning where a whole number in steps of 15 stands as it is, however it is spelled, and nowhere else.
print sin(90), cos(-45), tan(30), sin(60.0)
print sin(90deg), sin(90rad), sin(3), sin(15), cos(31)
let x = 90
print sin(x), sum(map([30, 60], sin))
