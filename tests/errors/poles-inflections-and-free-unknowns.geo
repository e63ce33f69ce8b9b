print solve(u => [u[0] * u[1]], start = [1, 1])
print minimize(x => exp(-x), start = 3)
print minimize(x => x^3, start = 1)
print minimize(x => -1/(x - 0.3)^2, within = 0..1)
print integrate(x => x, 0..1, tolerance = 0)
print maximize(x => 1/x, within = 0..1)
print minimize(x => sqrt(abs(x - 0.3)), within = 0..1), minimize(x => if x < 0.3 then -5 else 1, within = 0..1) < 0.3
print gradient(x => solve(y => y^3 - x, within = -5..5), 0)
