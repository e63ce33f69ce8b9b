// On its left a function with a condition is the piece before.
let k = 0.123456789
curve bent = parametric(t => (t, if t < k then 0 else (t - k)^2), 0..1)
check abs(curvature(bent, k, side = "left")) < 1e-9
check curvature(bent, k) ~= 2 within 1e-9
