let xs = [3, 1, 2, 3]
check len(xs) == 4 and sum(xs) == 9 and product(xs) == 18 and mean(xs) == 2.25
check sort(xs) == [1, 2, 3, 3] and unique(xs) == [3, 1, 2] and reverse(xs) == [3, 2, 1, 3]
check first(xs) == 3 and last(xs) == 3
check map(xs, x => 2*x) == [6, 2, 4, 6]
check filter(xs, x => x > 1) == [3, 2, 3]
check fold(xs, 100, (a, x) => a - x) == 91
check scan(xs, 0, (a, x) => a + x) == [3, 4, 6, 9]
check zip([1, 2], ["a", "b"]) == [[1, "a"], [2, "b"]]
check transpose([[1, 2, 3], [4, 5, 6]]) == [[1, 4], [2, 5], [3, 6]]
check flatten([[1], [2, 3], []]) == [1, 2, 3]
check any(xs, f = x => x == 2) and not any(xs, f = x => x > 3)
check every(xs, f = x => x > 0) and every([true, true]) and not any([false])
print scan(xs, 0, (a, x) => a + x), random(2), random(2, seed = 1)
check random(3) == random(3) "the same on every machine"
check sort([(1, 5)]) == [(1, 5)] and argmin([(1, 5)]) == 0 "one element needs no order"
