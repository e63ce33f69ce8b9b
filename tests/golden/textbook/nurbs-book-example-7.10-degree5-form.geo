// The NURBS Book: Full circle as one degree-5 rational Bezier with positive weights (Sec 10.3 (Example E7.10))
geo 1
// the circle of that form from its own constructor; the source does not fix where it starts
curve whole = circle((0, 0), 1, form = "degree-5")
check whole.degree == 5 and len(whole.points) == 6 and min(whole.weights) > 0
check [for t in linspace(0, 1, 9): norm(whole(t))] ~= [for t in linspace(0, 1, 9): 1] within 1e-12
