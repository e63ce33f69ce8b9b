fn sort_of(x) = if x < 0 then "negative" else if x == 0 then "zero" else "positive"
check sort_of(-1) == "negative" and sort_of(0) == "zero" and sort_of(1) == "positive"
// Only the branch that is taken is evaluated; so are `and` and `or`.
check (if true then 1 else 1/0) == 1
check true or 1/0 == 1
check not (false and 1/0 == 1)
check 1 < 2 and 2 < 3 or false
check not false and true
check 1 != 2 and "a" < "b" and none == none
let on_one_line = if 1 > 2 then "a" else "b"
print on_one_line
