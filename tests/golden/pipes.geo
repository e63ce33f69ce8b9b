// `a |> f(b)` is `f(a, b)`.
check ([3, 1, 2] |> sort) == [1, 2, 3]
check ([3, 1, 2] |> sort |> reverse) == [3, 2, 1]
check (1..5 |> filter(i => i % 2 == 1) |> map(i => i^2) |> sum) == 35
fn scaled(xs, by) = [for x in xs: x * by]
check ([1, 2] |> scaled(3)) == [3, 6]
check ((0, 0) |> circle(2)).start == (2, 0)
print [(0, 0), (1, 2), (2, 0)] |> bezier |> at(0.5)
