// Vukašinović, Duhovnik: Curvature of an explicit curve y=x^2/2 (EI=1): M = y''/(1+y'^2)^(3/2) ((1.6))
geo 1
curve c = parametric(t => (t, t^2/2), 0..2)
check signed_curvature(c, 0) ~= 1 within 1e-12
check signed_curvature(c, 1) ~= 0.35355339059327376 within 1e-12
check signed_curvature(c, 2) ~= 0.089442719099991588 within 1e-12
