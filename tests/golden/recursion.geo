fn factorial(n) = if n <= 1 then 1 else n * factorial(n - 1)
fn is_even(n) = if n == 0 then true else is_odd(n - 1)
fn is_odd(n) = if n == 0 then false else is_even(n - 1)
fn gcd(a, b) = if b == 0 then a else gcd(b, a % b)
// Cox and de Boor's recurrence.
fn basis(i, p, u, knots) =
  if p == 0 then (if knots[i] <= u and u < knots[i + 1] then 1 else 0)
  else share(u - knots[i], knots[i + p] - knots[i]) * basis(i, p - 1, u, knots)
     + share(knots[i + p + 1] - u, knots[i + p + 1] - knots[i + 1]) * basis(i + 1, p - 1, u, knots)
fn share(a, b) = if b == 0 then 0 else a / b
let given = [0, 0, 0, 1, 2, 3, 4, 4, 5, 5, 5]
print [for i in 0..7: basis(i, 2, 2.5, given)]
check factorial(10) == 3628800
check is_even(200) and not is_even(7)
check gcd(84, 36) == 12
// The NURBS Book, example 2.3.
check [for i in 2..4: basis(i, 2, 2.5, given)] == [1/8, 6/8, 1/8]
fn deep(n) = if n == 0 then 0 else 1 + deep(n - 1)
check deep(9000) == 9000
