// The NURBS Book: Rational sections: parameters from 4D (homogeneous) distances ((10.14))
geo 1
curve section0 = bezier((0, 0, 0), (1, 0, 2), (3, 0, 0), weights = [1, 2, 1])
curve section1 = bezier((0, 1, 1), (1, 2, 3), (3, 1, 0), weights = [1, 1/2, 1])
curve section2 = bezier((0, 4, 0), (2, 4, 2), (4, 4, 1), weights = [1, 1, 1])
surface s2 = skin([section0, section1, section2], degree = 2)
check [for u in linspace(0, 1, 5): s2(u, 0)] ~= [for u in linspace(0, 1, 5): section0(u)] within 1e-12
check [for u in linspace(0, 1, 5): s2(u, 0.3468931578034958)] ~= [for u in linspace(0, 1, 5): section1(u)] within 1e-12
check [for u in linspace(0, 1, 5): s2(u, 1)] ~= [for u in linspace(0, 1, 5): section2(u)] within 1e-12
check s2.points ~= [
  [(0, 0, 0), (0, 1.1446514208806595, 2.2069375137252479), (0, 4, 0)],
  [(1, 0, 2), (1.2541756233489743, -1.095533455175132, 0.94388202571448537), (2, 4, 2)],
  [(3, 0, 0), (2.7344284767888529, 1.1446514208806595, -0.2655715232111471), (4, 4, 1)],
] within 4e-12
check s2.weights ~= [[1, 1, 1], [2, -1.0448347473767247, 1], [1, 1, 1]] within 2e-12
check s2(1/3, 1/2) ~= (0.76076992534127574, 2.3942707402574704, 1.4480895412643669) within 2.39e-12
check s2(0.8, 0.1) ~= (2.0545740022608777, 0.21555412612804028, 0.85690900325759936) within 2.05e-12
