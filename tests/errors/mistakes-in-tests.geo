let one = 1
let two = nobody
test "names" {
    let a = b
    let one = 3
    let c = 1; let c = 2
    let d = e; let e = d
    let f = { let a = 1; a }
}
test "another test does not see them" {
    check a == 1
}
test "codes" {
    expect error "E0510" 1 / 0
    expect error "W0001" 1 / 0
    expect error "zero" 1 / 0
    expect error "E0{one}" 1 / 0
}
test "name {one}" {}
test "the broken definition of the file is told once" {
    check two == 2
}
test "still seen" {
    print elephant
}
