geo 1
param n = 3
let first = 1 / (n - n)
let second = 2 / (n - n)
let third = 3 / (n - n)
let fourth = 4 / (n - n)
let fifth = 5 / (n - n)
let sixth = 6 / (n - n)
let seventh = 7 / (n - n)
let fine = n
