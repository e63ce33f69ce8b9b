geo 1

// Σ k·x[k]² has the derivative 2k·x[k] by x[k].
let n = 3000
let place = [for k in 0..<n: 1 + k / n]
let slopes = gradient(x => sum([for k in 0..<n: k * x[k]^2]), place)
check len(slopes) == n
check max([for k in 0..<n: abs(slopes[k] - 2 * k * place[k])]) <= 1e-9
print slopes[1], slopes[2795], slopes[2796], slopes[2999]
