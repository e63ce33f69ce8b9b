// A warning where a whole number in steps of 15 stands as it is, and nowhere else.
print sin(90), cos(-45), tan(30)
print sin(90deg), sin(90rad), sin(3), sin(15), cos(31), sin(60.0)
let x = 90
print sin(x), sum(map([30, 60], sin))
