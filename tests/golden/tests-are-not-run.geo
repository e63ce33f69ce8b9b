// `run` resolves the names in tests, and evaluates nothing of them.
let one = 1
print one
test "fails" {
    let one_more = one + 1
    print one_more
    check one_more == 3
}
test "never ends well" {
    let one_more = 1 / 0
    expect error "E0501" one
    expect error "E0201" nobody
    export one_more to "never.xyz"
}
check one == 1
