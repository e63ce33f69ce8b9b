// Vukašinović, Duhovnik: Common tangent line but opposite tangent vectors: only G0 (Fig 1.34)
geo 1
curve p = bezier((0, 0), (1, 2), (3, 3), (5, 3))
curve r = bezier((5, 3), (4, 3), (3, 1), (2, 0))
check continuity(p, r).c == 0
check continuity(p, r).g == 0
