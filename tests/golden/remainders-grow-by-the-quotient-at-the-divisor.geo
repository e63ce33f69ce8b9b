// a % b is a - q * b with the whole quotient q = floor(a / b), so that it grows by da - q * db.
check gradient(x => 7 % x, 3) == -2 "7 = 2 * 3 + 1"
check gradient(x => -7 % x, 3) == 3 "-7 = -3 * 3 + 2"
check gradient(x => 7 % x, -3) == 3 "7 = -3 * -3 - 2"
check gradient(x => 5 * x % 3, 2) == 5
check gradient(x => x * x % (2 * x + 1), 4) == 6 "16 = 1 * 9 + 7, and 2 * 4 - 1 * 2 = 6"
check gradient(x => 47.5 % (x * x), 2) == -44 "47.5 = 11 * 4 + 3.5, and 11 * 2 * 2 = 44"
