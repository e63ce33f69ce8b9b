// Linkeová, Examples 2.8 and 2.10: C1 and C2 joining of Bézier cubics.
curve p = bezier((4, 1), (5, 0), (7, 0), (8, 2))
curve r = reversed(continue_bezier(reversed(p), 2, [(0, 4)]))
curve s = continue_bezier(p, 2, [(0, 4)])
check r.points ~= [(0, 4, 0), (3, 4, 0), (3, 2, 0), (4, 1, 0)] within 4e-11
check s.points ~= [(8, 2, 0), (9, 4, 0), (9, 8, 0), (0, 4, 0)] within 9e-11
check derivative(r, 0) ~= (9, 0, 0) within 9e-11
check derivative(r, 1, order = 2) ~= (6, 6, 0) within 6e-11
check r(1/2) ~= (11/4, 23/8, 0) within 2.87e-11
check derivative(s, 0, order = 2) ~= (-6, 12, 0) within 1.2e-10
check s(1/2) ~= (31/4, 21/4, 0) within 7.75e-11
// The C2 chain is one spline with simple knots.
curve chain = join([r, p, s])
check chain.knots ~= [0, 0, 0, 0, 1, 2, 3, 3, 3, 3]
check chain(0.5) ~= r(0.5) and chain(1.5) ~= p(0.5) and chain(2.5) ~= s(0.5)
print len(chain.points)
