let n = 3
let n = 4
fn area(width, width) = width * width
let inner = { let width = 4 let width = 5 width }
print [for i in 0..3, i in 0..2: i]
print [for [a, a] in [[1, 2]]: a]
let [p, p] = [1, 2]
// Inside a block that defines a name, it means the block's own, also above its definition.
let scale = 2
let taller = { let scale = scale * 3; scale }
test "twice" {
    let c = 1
    let c = 2
}
test "codes of mistakes that are none any more" {
    expect error "E0203" { let n = 2; n }
}
