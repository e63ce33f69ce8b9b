fn area(width, height) = widht * height
fn volume(depth) = { fn double(x) = 2 * x  dubble(depth) }
print area(2, 3), volume(4)
