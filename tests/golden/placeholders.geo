// An argument `_` makes a function of what is left out.
fn power(base, exponent) = base^exponent
let cube = power(_, 3)
let two_to = power(2, _)
check cube(2) == 8
check two_to(10) == 1024
check map([1, 2, 3], power(_, 2)) == [1, 4, 9]
check ([1, 2, 3] |> map(max(2, _))) == [2, 2, 3]
let through = bezier(_, weights = [1, 2, 1])
check through([(0, 0), (1, 1), (2, 0)]).rational
print cube(3), map([1, 4], sqrt(_))
