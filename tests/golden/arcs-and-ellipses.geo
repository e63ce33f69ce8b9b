curve quarter = arc((1, 2), 3, 0deg, 90deg)
check quarter.points ~= [(4, 2), (4, 5), (1, 5)] within 1e-15
check quarter.weights ~= [1, sqrt(2)/2, 1] within 1e-15

// Counter-clockwise to the next place of the angle.
check arc((0, 0), 1, 270deg, 90deg)(0.5) ~= (1, 0) within 1e-15
check arc((0, 0), 1, 90deg, 270deg)(0.5) ~= (-1, 0) within 1e-15
check length(arc((0, 0), 1, 0deg, -90deg)) ~= 1.5*pi within 1e-12
check [for turn in [90deg, 91deg, 180deg, 200deg, 1turn]: arc((0, 0), 1, 0deg, turn).segments] == [1, 2, 2, 3, 4]
check arc((0, 0), 1, 0deg, 1turn).closed
check arc((0, 0), 2, 0deg, 90deg, normal = (0, 1, 0)).end ~= (0, 0, -2) within 1e-15
check arc((0, 0), 2, 0deg, 90deg, x = (0, 1)).start ~= (0, 2) within 1e-15

// Through three points, whichever way they lie.
curve through = arc_through((3, 4), (0, -5), (5, 0))
check through.start == (3, 4)
check through.end == (5, 0)
check every([for t in linspace(0, 1, 40): norm(through(t)) ~= 5 within 1e-14])
check length(through) ~= 5*(2*pi - acos(0.6)/1rad) within 1e-12
check length(arc_through((1, 0, 0), (0, 1, 0), (0, 0, 1))) ~= sqrt(2/3)*240*pi/180 within 1e-12

curve oval = ellipse((0, 0), 4, 3)
check [for t in [0, 1/4, 1/2, 3/4]: oval(t)] ~= [(4, 0), (0, 3), (-4, 0), (0, -3)] within 1e-15
check curvature(oval, 1/4) ~= 3/16 within 1e-12
check length(oval) ~= 22.103492160709505 within 1e-12
check every([for t in linspace(0, 1, 40): (oval(t).x/4)^2 + (oval(t).y/3)^2 ~= 1 within 1e-15])
