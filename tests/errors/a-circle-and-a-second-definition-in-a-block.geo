let x = {
    let a = b
    let b = a
    let c = 1
    let c = 2
    a + c
}
