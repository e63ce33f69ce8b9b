// STEP has one vertex where loops touch; IGES keeps each loop to itself.
geo 1

surface pane = plane_patch((0, 0), (4, 0), (0, 2))
face pair = trim(pane, by = [circle((1.5, 1), 0.5), circle((2.5, 1), 0.5)], keep = (0.1, 0.1))
face notch = trim(pane, by = circle((1.5, 0.5), 0.5), keep = (0.1, 0.1))
face apart = trim(pane, by = [circle((1.5, 1), 0.5), circle((2.6, 1), 0.5)], keep = (0.1, 0.1))
export pair to "pair.igs"
export notch to "notch.igs"
export apart to "apart.igs"
