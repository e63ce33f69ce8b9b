curve c = parametric((a, b) => (a, b), 0..1)
