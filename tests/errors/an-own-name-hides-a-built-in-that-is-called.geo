let length = 5
print length(line((0, 0), (1, 0)))
fn norm(a, b) = a + b
print norm((1, 2))
let area = area(sphere((0, 0), 1))
