curve c = parametric(t => (t, t^2), 0..1)
print c.degree
print elevate(c, 5)
export c to "c.json"
