curve c = parametric(t => (t, 0), 1..1)
