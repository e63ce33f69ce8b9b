let n = 3
check n == 3 "the mark at the front of the file is no character of it"
