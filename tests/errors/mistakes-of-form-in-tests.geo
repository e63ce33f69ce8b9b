test "misplaced" {
    param p = 1
    print (1
}
test "expected errors are no statements of the file" {
    check 1 == 1
}
expect error "E0201" nobody
