// Closed forms: all of a parametric curve is asked about, and answers like any other.
curve unit_circle = parametric(t => (cos(t), sin(t)), 0..2*pi)
check length(unit_circle) ~= 2*pi within 1e-12
check bounds(unit_circle).min ~= (-1, -1) within 1e-14
check bounds(unit_circle).max ~= (1, 1) within 1e-14
check len(vertices(unit_circle)) == 0 and len(inflections(unit_circle)) == 0
check extrema(unit_circle, (0, 1)) ~= [pi/2, 3*pi/2] within 1e-14
check closest(unit_circle, (3, 4)).point ~= (0.6, 0.8) within 1e-15
check is_planar(unit_circle) and is_closed(unit_circle) and not is_straight(unit_circle)
check continuity(unit_circle).g == 3
check divide(unit_circle, 4) ~= [(1, 0), (0, 1), (-1, 0), (0, -1), (1, 0)] within 1e-14
check parameter_at_length(unit_circle, 2) ~= 2 within 1e-13

// A circle is a circle, in whichever form.
curve nurbs_circle = circle((0, 0), 1)
check length(nurbs_circle) ~= length(unit_circle) within 1e-12
check closest(nurbs_circle, (1, 7, 3)).distance ~= closest(unit_circle, (1, 7, 3)).distance within 1e-14
check [for m in intersect(unit_circle, line((-2, 0.5), (2, 0.5))): m.point] ~= [for m in intersect(nurbs_circle, line((-2, 0.5), (2, 0.5))): m.point] within 1e-14

curve ellipse_of = parametric(t => (4*cos(t), 3*sin(t)), 0..2*pi)
check length(ellipse_of) ~= 22.103492160709505 within 1e-11
check vertices(ellipse_of) ~= [0, pi/2, pi, 3*pi/2] within 1e-14

// The cycloid: an arch is 8 long, and ends in cusps.
curve cycloid = parametric(t => (t - sin(t), 1 - cos(t)), -1..13)
check cusps(cycloid) ~= [0, 2*pi, 4*pi] within 1e-13
check vertices(cycloid) ~= [pi, 3*pi] within 1e-13
check len(inflections(cycloid)) == 0
check length(cycloid, range = 0..2*pi) ~= 8 within 1e-12
check extrema(cycloid, (0, 1)) ~= [0, pi, 2*pi, 3*pi, 4*pi] within 1e-13

curve semicubical = parametric(t => (t^2, t^3), -1..1)
check length(semicubical) ~= 2*(13^1.5 - 8)/27 within 1e-12
check cusps(semicubical) == [0] and classify(semicubical, 0) == "cusp" and continuity(semicubical).g == 0
check len(inflections(semicubical)) == 0 and len(self_intersections(semicubical)) == 0

curve wave = parametric(t => (t, sin(t)), 0..10)
check inflections(wave) ~= [pi, 2*pi, 3*pi] within 1e-14
check vertices(wave) ~= [pi/2, 3*pi/2, 5*pi/2] within 1e-14
check [for m in intersect(wave, parametric(t => (t, cos(t)), 0..10)): m.t] ~= [pi/4, 5*pi/4, 9*pi/4] within 1e-14
check section(wave, plane((0, 0.5), (0, 1))) ~= [(pi/6, 0.5), (5*pi/6, 0.5), (13*pi/6, 0.5), (17*pi/6, 0.5)] within 1e-13

curve loop = parametric(t => (t^2, t^3 - t), -2..2)
check [for m in self_intersections(loop): (m.t, m.s)] ~= [(-1, 1)] within 1e-14
check inflections(parametric(t => (t, t^3), -1..2)) ~= [0] within 1e-14

curve catenary = parametric(t => (t, cosh(t)), -1..1)
check length(catenary) ~= 2*sinh(1) within 1e-13
curve spiral = parametric(t => (exp(t/5)*cos(t), exp(t/5)*sin(t)), 0..20)
check length(spiral) ~= sqrt(26)*(exp(4) - 1) within 1e-10
check len(vertices(spiral)) == 0 and len(inflections(spiral)) == 0
curve screw = parametric(t => (2*cos(t), 2*sin(t), t), 0..2*pi)
check length(screw) ~= 2*pi*sqrt(5) within 1e-12
check not is_planar(screw) and len(vertices(screw)) == 0

// Corners, and joints that are only C1.
curve roof = parametric(t => (t, abs(t - 0.3)), -1..1)
check corners(roof) ~= [0.3] within 1e-14
check length(roof) ~= 2*sqrt(2) within 1e-13
check bounds(roof).min ~= (-1, 0) within 1e-14
check classify(roof, 0.3) == "corner" and continuity(roof).g == 0
check extrema(roof, (0, 1)) ~= [0.3] within 1e-14
curve slide = parametric(t => if t < 1/3 then (t, 0) else (t, (t - 1/3)^2), 0..1)
check continuity(slide).c == 1 and len(corners(slide)) == 0
check length(to_nurbs(roof, 1e-9)) ~= 2*sqrt(2) within 1e-9
curve root = parametric(t => (t, sqrt(t)), 0..1)
check length(root) ~= (2*sqrt(5) + ln(2 + sqrt(5)))/4 within 1e-8
check distance(to_nurbs(root, 1e-6)(0.25), (0.25, 0.5)) < 1e-6

// Edits stay functions, exactly.
check trim(wave, 1..2)(1.5) == wave(1.5) and trim(wave, 1..2).domain.end == 2
check reversed(wave)(2.5) == wave(7.5)
check split(wave, 4)[1].start == wave(4)
check reparametrize(wave, 0..1)(0.25) == wave(2.5)
check derivative(reparametrize(wave, 0..1), 0.25) ~= 10*derivative(wave, 2.5) within 1e-14
check hodograph(wave)(1) == derivative(wave, 1)
check length(extend(catenary, 2)) ~= 2*sinh(1) + 2 within 1e-12
check extend(unit_circle, 1).domain.end ~= 2*pi + 1 within 1e-12
check offset(unit_circle, 1)(1) ~= (2*cos(1), 2*sin(1)) within 1e-6
check join([trim(wave, 0..4), trim(wave, 4..10)])(7) ~= wave(7) within 1e-12
export wave to "wave.obj" with (tolerance = 0.1)
