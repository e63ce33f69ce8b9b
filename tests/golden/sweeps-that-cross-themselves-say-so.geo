// What a sweep cannot promise it tells, with the parameters.
let ring = circle((0, 0, 0), 1, normal = (1, 0, 0))
let bow = bezier((0, 0), (1, 3), (2, 0))
surface folded = sweep(scale(ring, 0.5), bow)
print report(folded).folds
// The radius of curvature at the middle is 1/3.
check len(report(folded).folds) == 1
check report(folded).folds[0][0] + report(folded).folds[0][1] ~= 1 within 1e-9
surface thin = sweep(scale(ring, 0.3), bow)
check report(thin).folds == []
// A scale that passes zero; one that ends there is a tip.
surface waist = sweep(ring, line((0, 0, 0), (4, 0, 0)), scale = v => 1 - 2*v)
check report(waist).collapses[0] ~= 0.5 within 1e-9
surface tip = sweep(ring, line((0, 0, 0), (4, 0, 0)), scale = [1, 0])
check report(tip).collapses == []
check norm(tip(0.3, 1) - (4, 0, 0)) < 1e-15
// Legs too short for their mitres.
surface short = sweep(ring, polyline((0, 0, 0), (5, 0, 0), (5.5, 0.5, 0), (5, 5, 0)), corner = "miter", scale = 1)
print report(short).corners
surface stub = sweep(ring, polyline((0, 0, 0), (0.5, 0, 0), (0.5, 5, 0)), corner = "miter")
surface nearly_back = sweep(ring, polyline((0, 0, 0), (5, 0, 0), (0, 0, 0.1)), corner = "miter")
// Along the path a section without depth has nothing to lose.
surface same = sweep(ring, line((0, 0, 0), (4, 0, 0)), scale = v => (v - 0.5, 1, 1))
check report(same).collapses == []
