print parametric(5, 0..1)
