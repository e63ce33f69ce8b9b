// The curve is the sum of its points times the Bernstein polynomials.
let net = [(0, 0), (1, 2), (3, 2), (4, 0)]
let c = bezier(net)
fn choose(n, k) = if k == 0 then 1 else choose(n - 1, k - 1) * n / k
fn bernstein(i, t) = choose(3, i) * t^i * (1 - t)^(3 - i)
check [for k in 0..3: choose(3, k)] == [1, 3, 3, 1]
let at_hand = [for t in linspace(0, 1, 11): fold(0..3, (0, 0), (sum_so_far, i) => sum_so_far + bernstein(i, t) * net[i])]
check [for t in linspace(0, 1, 11): c(t)] ~= at_hand within 1e-14
check [for t in linspace(0, 1, 5): sum([for i in 0..3: bernstein(i, t)])] ~= [1, 1, 1, 1, 1] within 1e-15
