let y = {
  let a = 2
  fn square(x) = x * x
  curve c = line((0, 0), (a, 0))
  square(c(0.5).x) + a
}
fn arch(width, height) = {
  let half = width / 2
  bezier((0, 0), (half, 2 * height), (width, 0))
}
let made = { let a = 1 { let b = a + 1 b + a } }
print y, arch(4, 3), made
check y == 3
check arch(4, 3)(0.5) == (2, 3)
check made == 3
// The names of one block are its own.
let other = { let a = 5 a }
check other == 5
