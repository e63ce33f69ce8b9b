let radius = 10
print radius
let radius = 12
fn f(a, a) = a
