// A `(`, `[` or `-` that begins a line never continues the expression before it.
let f = {
  let a = 1
  (a, 2)
}
let g = {
  let xs = [1, 2]
  [xs[0]]
}
let h = {
  let a = 1
  -a
}
let on_one_line = { let p = 3; (p, 2) }
// An operator at the end of a line, or a call that is already open, goes on.
let sum = 1 +
  2
let call = max(
  1,
  2,
)
let piped = [1, 2, 3]
  |> sum_of
fn sum_of(xs) = fold(xs, 0, (a, x) => a + x)
print f, g, h, on_one_line, sum, call, piped
check f == (1, 2)
check g == [1]
check h == -1
check on_one_line == (3, 2)
