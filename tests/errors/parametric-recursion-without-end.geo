curve c = parametric(t => { fn loop(n) = loop(n + 1); (t, loop(0)) }, 0..1)
