curve c = parametric(t => 2*t, 0..1)
