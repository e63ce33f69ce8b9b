// Holes that touch one another, or the border, in a point: each is a loop of its own, and both have a vertex there.
geo 1

surface pane = plane_patch((0, 0), (4, 0), (0, 2))
face pair = trim(pane, by = [circle((1.5, 1), 0.5), circle((2.5, 1), 0.5)], keep = (0.1, 0.1))
face notch = trim(pane, by = circle((1.5, 0.5), 0.5), keep = (0.1, 0.1))
check area(pair) ~= 8 - 0.5 * pi within 1e-9
check area(notch) ~= 8 - 0.25 * pi within 1e-9
export pair to "pair.step"
export notch to "notch.step"
