// A name may be used above its definition.
print volume
let volume = width * depth * height
let height = depth + 1
let width = 2
let depth = double(width)
fn double(x) = x * factor
let factor = 2
check volume == 2 * 4 * 5
let inside = { let b = a + 1  let a = 1  b }
check inside == 2 "in blocks too"
