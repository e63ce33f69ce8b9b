curve c = parametric(t => (t, t^2), 0..1)
print c.degree
print ruled(c, line((0, 0), (1, 0)))
export c to "c.json"
