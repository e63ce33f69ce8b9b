curve c = parametric(t => parametric(s => (s, t), 0..1)(0.5), 0..1)
print c(0.5)
print derivative(c, 0.5)
