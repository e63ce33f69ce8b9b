geo 1
param n = 3
let inverse = 1 / (n - n)
let root = sqrt(n - 5)
let fine = n
