let n = 3
let share = 1 / (n - 3)
print 0 / 0, 5 % 0, (1, 2) / 0, 0^-1
