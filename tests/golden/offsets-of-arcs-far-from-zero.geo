// Lines and arcs stay such wherever a region is.
fn plate(o) = region(circle(o, 3.5), holes = [circle(o + (1, 0.4), 0.6)])
fn slot(o) = region([line(o + (-2, -1), o + (2, -1)), arc(o + (2, 0), 1, -90deg, 90deg), line(o + (2, 1), o + (-2, 1)), arc(o + (-2, 0), 1, 90deg, 270deg)])
let places = [(0, 0), (6000, 2000), (-12345.678, 9876.543), (1e6/3, 1e5/7)]
let inner = [for o in places: offset(plate(o), -0.5)[0]]
check every(inner, r => r.outer.degree == 2 and r.holes[0].degree == 2)
check every(inner, r => area(r) ~= pi*(3^2 - 1.1^2) within 1e-8)
let outer = [for o in places: offset(slot(o), 0.25)[0]]
check every(outer, r => area(r) ~= 4 * 2.5 + pi * 1.25^2 within 1e-8)
