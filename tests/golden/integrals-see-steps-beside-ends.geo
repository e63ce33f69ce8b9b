// Steps of a load nearer and nearer to an end of the range, added to what is smooth.
let steps = [for k in 3..12: 0.37 * 10^-k]
check [for d in steps: integrate(x => cos(x) + (if x < d then 1 else 0), 0..1)] ~= [for d in steps: sin(1) + d] within 1e-12
check [for d in steps: integrate(x => 2 + (if x > 3 - d then 5 else 0), 1..3)] ~= [for d in steps: 4 + 5 * d] within 1e-11
check integrate(x => (1/x)^2, 1..1e300) ~= 1
