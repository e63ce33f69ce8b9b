curve c = parametric(t => (1/(t - 0.5), 0), 0..1)
