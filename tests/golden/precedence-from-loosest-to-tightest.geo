let c = true
// if, lambda, pipe, or, and, not, comparison, range, + -, * / %, unary -, ^, call
check (if c then 1 else 2 + 10) == 1
check (x => x + 1)(1) == 2
check (if false then 1 else 2 |> max(5)) == 5
check ([1, 2] |> map(x => x * 2)) == [2, 4]
check true or false and false "and binds tighter than or"
check not 1 == 2 "not binds looser than comparison"
check 1 + 2 == 3 and 1..2 + 1 == 1..3 "a range is looser than a sum"
check 2 + 3 * 4 == 14 and 7 - 2 - 1 == 4 and 8 / 4 / 2 == 1
check 2 * 7 % 4 == 2 and 7 % 4 * 2 == 6 "* / % from left to right"
check -2^2 == -4 and 2^-1 == 0.5 and 2^3^2 == 512
check -[3, 4][0] == -3 and [2, 3][1]^2 == 9
check [1.5, 2.5][0] + {a: 1}.a == 2.5
