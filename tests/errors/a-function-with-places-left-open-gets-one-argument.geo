// Those left open by name count as those by position do.
fn f(a, b, c) = 100 * a + 10 * b + c
let g = f(_, 2, c = _)
let h = f(_, b = _, c = 3)
check g(1, 3) == 123 and h(1, 2) == 123
print g(1)
print h(1, 2, 3)
