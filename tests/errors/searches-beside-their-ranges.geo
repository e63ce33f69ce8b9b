print maximize(x => x, within = 0..<5)
print solve(x => x - 5, within = 0..<5)
print minimize(u => (u.a - 10)^2, start = {a: 90}, within = {a: 20..60})
print maximize(p => -norm(p), start = (5, 0), within = [0..1, 0..1])
