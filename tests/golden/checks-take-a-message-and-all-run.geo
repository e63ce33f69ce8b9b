check 1 < 2
check 1 < 2 and 2 < 3 or false "with a message"
check "n = {1 + 1}" == "n = 2" "message {1 + 1} of {2}"
check not false
check [1, 2] != [1, 3]
check every([1, 2], n => n > 0)
