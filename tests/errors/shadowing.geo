let width = 3
fn area(width, height) = width * height
let inner = { let width = 4 width }
print [for width in 0..3: width]
