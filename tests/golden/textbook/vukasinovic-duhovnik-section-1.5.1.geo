// Vukašinović, Duhovnik: Helix (2cos t, 2 sin t, t): Frenet frame, curvature 2/5, torsion 1/5 ((1.54)-(1.57))
geo 1
curve c = parametric(t => (2*cos(t), 2*sin(t), t), 0..2*pi)
check c(0) ~= (2, 0, 0) within 2e-12
check derivative(c, 0) ~= (0, 2, 1) within 2e-12
check derivative(c, 0, order = 2) ~= (-2, 0, 0) within 2e-12
check tangent(c, 0) ~= (0, 0.89442719099991588, 0.44721359549995794) within 1e-12
check normal(c, 0) ~= (-1, 0, 0) within 1e-12
check binormal(c, 0) ~= (0, -0.44721359549995794, 0.89442719099991588) within 1e-12
check curvature(c, 0) ~= 0.4 within 1e-12
check radius_of_curvature(c, 0) ~= 2.5 within 2.5e-12
check center_of_curvature(c, 0) ~= (-0.5, 0, 0) within 1e-12
check torsion(c, 0) ~= 0.2 within 1e-12
check curvature(c, 0) ~= 2/5 within 1e-12
check torsion(c, 0) ~= 1/5 within 1e-12
check c(pi/3) ~= (1, 1.7320508075688773, 1.0471975511965977) within 1.73e-12
check derivative(c, pi/3) ~= (-1.7320508075688773, 1, 1) within 1.73e-12
check derivative(c, pi/3, order = 2) ~= (-1, -1.7320508075688773, 0) within 1.73e-12
check tangent(c, pi/3) ~= (-0.77459666924148338, 0.44721359549995794, 0.44721359549995794) within 1e-12
check normal(c, pi/3) ~= (-0.5, -0.86602540378443865, 0) within 1e-12
check binormal(c, pi/3) ~= (0.38729833462074169, -0.22360679774997897, 0.89442719099991588) within 1e-12
check curvature(c, pi/3) ~= 0.4 within 1e-12
check radius_of_curvature(c, pi/3) ~= 2.5 within 2.5e-12
check center_of_curvature(c, pi/3) ~= (-0.25, -0.43301270189221932, 1.0471975511965977) within 1.05e-12
check torsion(c, pi/3) ~= 0.2 within 1e-12
check curvature(c, pi/3) ~= 2/5 within 1e-12
check torsion(c, pi/3) ~= 1/5 within 1e-12
check c(2) ~= (-0.83229367309428477, 1.8185948536513634, 2) within 2e-12
check derivative(c, 2) ~= (-1.8185948536513634, -0.83229367309428477, 1) within 1.82e-12
check derivative(c, 2, order = 2) ~= (0.83229367309428477, -1.8185948536513634, 0) within 1.82e-12
check tangent(c, 2) ~= (-0.81330034325914603, -0.3722130460563617, 0.44721359549995794) within 1e-12
check normal(c, 2) ~= (0.41614683654714239, -0.9092974268256817, 0) within 1e-12
check binormal(c, 2) ~= (0.40665017162957302, 0.18610652302818085, 0.89442719099991588) within 1e-12
check curvature(c, 2) ~= 0.4 within 1e-12
check radius_of_curvature(c, 2) ~= 2.5 within 2.5e-12
check center_of_curvature(c, 2) ~= (0.20807341827357119, -0.45464871341284085, 2) within 2e-12
check torsion(c, 2) ~= 0.2 within 1e-12
check curvature(c, 2) ~= 2/5 within 1e-12
check torsion(c, 2) ~= 1/5 within 1e-12
check length(c, range = 0..2*pi) ~= 14.049629462081453 within 1.4e-11
