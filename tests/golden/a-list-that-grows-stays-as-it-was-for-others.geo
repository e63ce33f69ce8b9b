// A list that grows in a function takes the memory of the one before, unless somebody else has that.
let start = [for i in 0..<100: i]
let places = [for i in 0..<100: (i, 0)]
fn grown(list, x) = [...list, x]
fn grown_twice(list, x) = [grown(list, x), grown(list, -x), list]
fn kept(list, x) = { let before = [...list]  let f = () => list[-1]; [...list, x, f(), len(before)] }
fn mixed(list, x) = if x % 2 == 0 then [...list, x] else [...list, "{x}"]

check len(start) == 100 and start[-1] == 99 "numbers"
check len(grown(start, 7)) == 101 and len(start) == 100
check [for list in grown_twice(start, 7): list[-1]] == [7, -7, 99]
check [for list in grown_twice(places, (7, 1)): list[-1]] == [(7, 1), (-7, -1), (99, 0)] "points"
check [for x in kept(start, 5)[-3..-1]: x] == [5, 99, 100] "what a function inside holds"

let all = fold(0..<500, [], (list, i) => [...list, i])
check all == [for i in 0..<500: i]
let steps = scan(0..<200, start, (list, i) => [...list, i])
check [for i in 0..<200: len(steps[i])] == [for i in 0..<200: 101 + i] "every step stays"
let twice = fold(0..<300, [], (list, i) => [...list, i, ...[i, i]])
check len(twice) == 900 and twice[-1] == 299
let lengths = fold(0..<100, [for i in 0..<100: i * 1mm], (list, i) => [...list, i])
check len(lengths) == 200 and lengths[99] == 99mm and lengths[199] == 99 "another dimension"
let words = fold(0..<200, [], mixed)
check words[198] == 198 and words[199] == "199"
let of_rows = fold(0..<3, table({a: [1, 2]}), (list, i) => [...list, i])
check len(of_rows) == 5 and of_rows[1].a == 2
let of_range = fold(0..<2, 0..2, (list, i) => [...list, 10 + i])
check of_range == [0, 1, 2, 10, 11]

// Of a function that calls itself at last, what it gives the next call.
fn down(n, list) = if n == 0 then list else down(n - 1, [...list, n])
check down(500, []) == [for i in 0..<500: 500 - i]
check len(down(3, start)) == 103 and len(start) == 100 "what others have"
fn first(list, n) = if n == 0 then list else first([...list, n], n - 1)
check first([], 400) == [for i in 0..<400: 400 - i] "what stands behind names it not"
fn tail(list, n) = if n == 0 then list else tail([...list, n, ...list[-2..-1]], n - len(list))
check tail([1, 2], 7) == [1, 2, 7, 1, 2, 5, 1, 2] "what stands behind names it"
fn both(a, b, n) = if n == 0 then [len(a), len(b)] else both([...a, n], [...a, ...b], n - 1)
check both([], [], 3) == [3, 3] "two lists of one"
fn inner(n, list) = if n == 0 then list else { let m = 2 * n; inner(n - 1, if n % 2 == 0 then [...list, m] else [...list, -m, len(list)]) }
check inner(4, []) == [8, -6, 1, 4, -2, 4] "behind conditions and names"
fn held(n, list) = { let f = () => len(list); if n == 0 then [] else [f(), ...held(n - 1, [...list, n])] }
check held(3, []) == [0, 1, 2] "what a function inside holds"
fn later(n, list) = if n == 0 then [] else [...later(n - 1, [...list, n]), len(list)]
check later(3, []) == [2, 1, 0] "what is asked for after the call"
fn labelled(n, list = [], more = 0) = if n == 0 then list else labelled(list = [...list, n], n = n - 1, more = len(list))
check labelled(3) == [3, 2, 1] "by name"

// By a name of a block, from which the last call has it.
fn named(n, list) = if n == 0 then list else { let m = [...list, n]; named(n - 1, m) }
check named(500, []) == [for i in 0..<500: 500 - i]
check len(named(3, start)) == 103 and len(start) == 100 "what others have"
fn chain(n, list) = if n == 0 then list else { let m = [...list, n]  let k = [...m, -n]; if n % 2 == 0 then chain(n - 1, k) else chain(list = k, n = n - 1) }
check chain(3, []) == [3, -3, 2, -2, 1, -1] "one out of another"
fn beside(n, list) = if n == 0 then list else { let m = [...list, n]  let k = [...list, -n]; beside(n - 1, [...m, len(k), len(list)]) }
check beside(2, [5]) == [5, 2, 2, 1, 1, 5, 4] "two of one"
fn joined(a, b) = [...a, ...b]
fn twofold(n, list) = { let m = [...list, n]; joined(m, m) }
check twofold(1, [2]) == [2, 1, 2, 1] "two arguments of one"
fn after(n, list) = { let m = [...list, n]; joined(m, [len(m)]) }
check after(1, [2]) == [2, 1, 2] "named by an argument behind"
fn inside(n, list) = { let m = [...list, n]  let f = () => [...m, len(list)]; joined(m, f()) }
check inside(1, [2]) == [2, 1, 2, 1, 1] "held by a function inside"
fn pinned(n, list) = { points m = [...list, (n, 0)]; if n == 0 then m else pinned(n - 1, m) }
check pinned(2, []) == [(2, 0), (1, 0), (0, 0)] "of a kind"
