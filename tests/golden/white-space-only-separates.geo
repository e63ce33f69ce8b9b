let a=1 let b
  =
    2; let c = a
+ b;; print a, b, c
check [
  1,
  2
] == [1, 2] check a + b == c
fn f(
  x,
) = x * 2 check f(
  3
) == 6
