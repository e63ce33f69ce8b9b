let _depth = 3
fn _double(x) = 2 * x
let width = _double(_depth)
print width, _depth
