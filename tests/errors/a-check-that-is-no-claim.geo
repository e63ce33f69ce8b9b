let a = 3
check a
check a + 1 "a message"
