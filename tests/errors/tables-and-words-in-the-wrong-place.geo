let t = table([{x: 1, y: 2}, {x: 3, y: 4}])
print [for x in 3mm: x]
print volume([parametric((u, v) => (u, v), 0..1, 0..1), face(plane_patch((0, 0), (1, 0), (0, 1)))])
print minimize(u => u.a, start = {a: 1}, subject = u => [for k in 1..2: k])
