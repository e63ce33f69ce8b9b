geo 1
let first = 1 / 0
let second = 2 / 0
let third = 3 / 0
let fourth = 4 / 0
let fifth = 5 / 0
let fine = 1
