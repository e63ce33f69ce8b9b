// Trimmed faces and solids: what other programs make of them is compared with `trimmed.csv` by `trimmed.py`.
geo 1
unit mm

surface ball = sphere((0, 0, 0), 2)
surface tube = cylinder((0, 0, -3), 1, 6)
surface hat = cone((0, 0, 0), 2, 0, 3)
surface ring = torus((0, 0, 0), 3, 1)
surface elbow = revolve(rotate(circle((3, 0, 0), 1, normal = (0, 1, 0)), 50deg, axis = (0, 1, 0), about = (3, 0, 0)), axis = (0, 0, 1), angle = 90deg)
surface wave = interpolate([for i in 0..4: [for j in 0..4: (i, j, 0.5 * sin(i) * cos(0.7 * j))]])
let wave_height = 0.5 * sin(2) * cos(1.4)
surface egg = scale(ball, (1, 1, 1.5))
surface dome = bezier([[(0, 0, 0), (0, 1, 0.2), (0, 2, 0)], [(2, 0, 0.3), (2, 1, 1), (2, 2, 0.3)], [(4, 0, 0), (4, 1, 0.2), (4, 2, 0)]])
surface vase = revolve(interpolate([(1, 0, 0), (1.4, 0, 0.7), (0.8, 0, 1.6), (1, 0, 2.4)]))
fn project_circle(x, y) = parametric(t => (x + 0.5 * cos(t), y + 0.5 * sin(t), 1 + (y + 0.5 * sin(t)) / 4), 0..tau)

// Spheres: beside meridians, over poles and seams, small, with holes.
face ball_cap = trim(ball, by = plane((0, 0, 1.9), (0, 0, 1)), keep = "above")
face ball_dot = trim(ball, by = plane((1.6, 1.1, 0.4), (1.6, 1.1, 0.4)), keep = "above")
face ball_side = trim(ball, by = plane((1.9, 0.3, 0), (1, 0.2, 0.3)), keep = "above")
face ball_back = trim(ball, by = plane((-1.2, 0.3, 0), (-1, 0.2, 0.3)), keep = "above")
face ball_tilted = trim(ball, by = plane((0.1, 0.03, 0.3), (1, 0.2, 0.3)), keep = "above")
face ball_polar = trim(ball, by = plane((0, 0, 1.7), (0.3, 0.1, 1)), keep = "above")
face ball_without = trim(ball, by = plane((0, 0, 1.7), (0.3, 0.1, 1)), keep = "below")
face ball_by_pole = trim(ball, by = plane((0, 0, 2), (1, 0.2, 1)), keep = "above")
face ball_half = trim(ball, by = plane((0, 0, 0), (1, 0.37, 0)), keep = "above")
face ball_near_meridian = trim(ball, by = plane((0.01, 0, 0), (1, 0.02, 0.001)), keep = "above")
face ball_belt = trim(trim(ball, by = plane((0, 0, -0.5), (0.1, 0.2, 1)), keep = "above"), by = plane((0, 0, 0.7), (0.2, 0, 1)), keep = "below")
face ball_pierced = trim(ball, by = cylinder((1, 0, -3), 0.5, 6), keep = (-2, 0, 0))
face ball_window = trim(ball, by = cylinder((1, 0.2, -3), 0.6, 6), keep = (1, 0.2, sqrt(2.96)))
face ball_leaf = trim(ball, by = [plane((0, 0, 0), (1, 0.3, 0.2)), plane((0, 0, 0), (0.2, -1, 0.7)), plane((0, 0, 0.2), (0, 0.1, 1))], keep = (1, -1, sqrt(2)))
// Cylinders.
face tube_slant = trim(tube, by = plane((0, 0, 0.3), (1, 0.2, 1)), keep = "below")
face tube_steep = trim(tube, by = plane((0.2, 0, 0.3), (1, 0.2, 0.1)), keep = "below")
face tube_side = trim(tube, by = plane((0.2, 0.1, 0), (1, 0.4, 0)), keep = "above")
face tube_hole = trim(tube, by = cylinder((-3, 0.1, 0), 0.7, 6, axis = (1, 0, 0)), keep = (0, 1, 2))
face tube_port = trim(tube, by = cylinder((0, 0.1, 0.2), 0.7, 6, axis = (1, 0, 0)), keep = (sqrt(0.99), 0.1, 0.2))
face tube_arcs = face(tube, [join([line((1, 0, -1), (1, 0, 1)), arc((0, 0, 1), 1, 0deg, 100deg), line((cos(100deg), sin(100deg), 1), (cos(100deg), sin(100deg), -1)), reversed(arc((0, 0, -1), 1, 0deg, 100deg))])])
// Cones.
face hat_slant = trim(hat, by = plane((0, 0, 1), (0.3, 0.2, 1)), keep = "below")
face hat_tip = trim(hat, by = plane((0, 0, 1), (0.3, 0.2, 1)), keep = "above")
face hat_parabola = trim(hat, by = plane((0.5, 0, 0), (3, 0, 2)), keep = "above")
face hat_hyperbola = trim(hat, by = plane((0.5, 0.1, 0), (1, 0.1, 0)), keep = "above")
face hat_hole = trim(hat, by = cylinder((-3, 0.1, 1), 0.4, 6, axis = (1, 0.3, 0.1)), keep = (0, 0, 3))
// Tori.
face ring_slant = trim(ring, by = plane((0.1, 0, 0), (1, 0.2, 0.4)), keep = "above")
face ring_top = trim(ring, by = plane((0, 0, 0.3), (0.05, 0.1, 1)), keep = "above")
face ring_hole = trim(ring, by = cylinder((3, 0.2, -3), 0.4, 6), keep = (-3, 0, 1))
face ring_port = trim(ring, by = cylinder((3, 0.2, 0), 0.4, 6), keep = (3, 0.2, sqrt(1 - (sqrt(9.04) - 3) ^ 2)))
face elbow_part = trim(elbow, by = plane((3, 1, 0), (0.3, 1, 0.4)), keep = "above")
// Planes.
face pane_round = face(plane_patch((0, 0), (4, 0), (0, 4)), [circle((2, 2), 1)])
face pane_holes = face(plane_patch((0, 0, 1), (4, 0, 0), (0, 4, 1)), [reversed(project_circle(1, 1)), reversed(project_circle(3, 2.5))])
face pane_notched = trim(plane_patch((0, 0), (4, 0), (0, 2)), by = circle((1.5, 0.5), 0.5), keep = (0.1, 0.1))
// NURBS.
face wave_round = trim(wave, by = cylinder((2, 2, -5), 1.2, 10), keep = (2, 2, wave_height))
face wave_rest = trim(wave, by = cylinder((2, 2, -5), 1.2, 10), keep = wave(0, 0))
face dome_touching = trim(dome, by = [cylinder((1.5, 1, -2), 0.5, 5), cylinder((2.5, 1, -2), 0.5, 5)], keep = dome(0.02, 0.02))
face wave_half = trim(wave, by = plane((2, 2, 0), (1, 0.7, 0.1)), keep = "above")
face wave_uv = face(wave, [polyline([(0.1, 0.1), (0.4, 0.15), (0.6, 0.9), (0.2, 0.7)], closed = true)], space = "uv")
face egg_half = trim(egg, by = plane((0.2, 0, 0), (1, 0.3, 0.2)), keep = "above")
face vase_part = trim(vase, by = plane((0.2, 0, 1), (0.7, 0.3, 1)), keep = "below")
face vase_hole = trim(vase, by = cylinder((0, 0.1, 1), 0.3, 6, axis = (1, 0.1, 0)), keep = vase(0.5, 0))
// Solids.
solid plate = extrude(region(polyline([(0, 0), (4, 0), (4, 2), (0, 2)], closed = true), holes = [circle((1, 1), 0.5), ellipse((3, 1), 0.6, 0.3)]), (0, 0, 0.3))
solid thin = extrude(region(polyline([(0, 0), (4, 0), (4, 2), (0, 2)], closed = true)), (0, 0, 0.0001))
solid leaning = extrude(region(circle((0, 0), 1)), (1, 0.3, 3))
solid pipe = revolve(region(circle((3, 0), 1), holes = [circle((3.2, 0), 0.5)]), axis = (0, 1, 0))
solid bend = revolve(region(circle((3, 0), 1), holes = [circle((3.2, 0), 0.5)]), axis = (0, 1, 0), angle = -90deg)
solid pear = revolve(region(join([bezier((0, 0), (2, 0), (0.5, 2), (0, 3)), line((0, 3), (0, 0))])), axis = (0, 1, 0))
solid ball_cut = cut(solid(ball), plane((0.5, 0, 0.3), (1, 0.2, 0.3)))
solid ball_twice = cut(ball_cut, plane((0, 0, 1), (0.1, 0, 1)))
solid ball_quarter = cut(cut(solid(ball), plane((0, 0, 0), (1, 0, 0))), plane((0, 0, 0), (0, 0.6, 0.8)))
solid log_cut = cut(solid(tube, cap = true), plane((0, 0, 0.3), (1, 0.2, 1)))
solid log_thin = cut(cut(solid(tube, cap = true), plane((0, 0, 0.3), (1, 0.2, 1))), plane((0, 0, 0.299), (1, 0.2, 1)), keep = "above")
solid hat_cut = cut(solid([hat, disc((0, 0, 0), 2, normal = (0, 0, -1))]), plane((0.3, 0, 1), (1, 0.2, 0.5)))
solid ring_cut = cut(solid(ring), plane((0.2, 0.1, 0.1), (0.3, 0.1, 1)))
solid ring_half = cut(solid(ring), plane((0.2, 0.1, 0.1), (1, 0.1, 0.1)))
solid pipe_cut = cut(pipe, plane((0.2, 0.1, 0.1), (0.3, 1, 0.2)))
solid vase_cut = cut(solid(vase, cap = true), plane((0.2, 0, 1.2), (0.4, 0.3, 1)))
solid shell = solid([ball, sphere((0.1, 0, 0.2), 1)])
solid shell_cut = cut(shell, plane((0, 0.1, 0), (0.1, 1, 0.3)))

export ball_cap to "trimmed/ball_cap.step"
export ball_cap to "trimmed/ball_cap.igs"
export ball_dot to "trimmed/ball_dot.step"
export ball_dot to "trimmed/ball_dot.igs"
export ball_side to "trimmed/ball_side.step"
export ball_side to "trimmed/ball_side.igs"
export ball_back to "trimmed/ball_back.step"
export ball_back to "trimmed/ball_back.igs"
export ball_tilted to "trimmed/ball_tilted.step"
export ball_tilted to "trimmed/ball_tilted.igs"
export ball_polar to "trimmed/ball_polar.step"
export ball_polar to "trimmed/ball_polar.igs"
export ball_without to "trimmed/ball_without.step"
export ball_without to "trimmed/ball_without.igs"
export ball_by_pole to "trimmed/ball_by_pole.step"
export ball_by_pole to "trimmed/ball_by_pole.igs"
export ball_half to "trimmed/ball_half.step"
export ball_half to "trimmed/ball_half.igs"
export ball_near_meridian to "trimmed/ball_near_meridian.step"
export ball_near_meridian to "trimmed/ball_near_meridian.igs"
export ball_belt to "trimmed/ball_belt.step"
export ball_belt to "trimmed/ball_belt.igs"
export ball_pierced to "trimmed/ball_pierced.step"
export ball_pierced to "trimmed/ball_pierced.igs"
export ball_window to "trimmed/ball_window.step"
export ball_window to "trimmed/ball_window.igs"
export ball_leaf to "trimmed/ball_leaf.step"
export ball_leaf to "trimmed/ball_leaf.igs"
export tube_slant to "trimmed/tube_slant.step"
export tube_slant to "trimmed/tube_slant.igs"
export tube_steep to "trimmed/tube_steep.step"
export tube_steep to "trimmed/tube_steep.igs"
export tube_side to "trimmed/tube_side.step"
export tube_side to "trimmed/tube_side.igs"
export tube_hole to "trimmed/tube_hole.step"
export tube_hole to "trimmed/tube_hole.igs"
export tube_port to "trimmed/tube_port.step"
export tube_port to "trimmed/tube_port.igs"
export tube_arcs to "trimmed/tube_arcs.step"
export tube_arcs to "trimmed/tube_arcs.igs"
export hat_slant to "trimmed/hat_slant.step"
export hat_slant to "trimmed/hat_slant.igs"
export hat_tip to "trimmed/hat_tip.step"
export hat_tip to "trimmed/hat_tip.igs"
export hat_parabola to "trimmed/hat_parabola.step"
export hat_parabola to "trimmed/hat_parabola.igs"
export hat_hyperbola to "trimmed/hat_hyperbola.step"
export hat_hyperbola to "trimmed/hat_hyperbola.igs"
export hat_hole to "trimmed/hat_hole.step"
export hat_hole to "trimmed/hat_hole.igs"
export ring_slant to "trimmed/ring_slant.step"
export ring_slant to "trimmed/ring_slant.igs"
export ring_top to "trimmed/ring_top.step"
export ring_top to "trimmed/ring_top.igs"
export ring_hole to "trimmed/ring_hole.step"
export ring_hole to "trimmed/ring_hole.igs"
export ring_port to "trimmed/ring_port.step"
export ring_port to "trimmed/ring_port.igs"
export elbow_part to "trimmed/elbow_part.step"
export elbow_part to "trimmed/elbow_part.igs"
export pane_round to "trimmed/pane_round.step"
export pane_round to "trimmed/pane_round.igs"
export pane_holes to "trimmed/pane_holes.step"
export pane_holes to "trimmed/pane_holes.igs"
export pane_notched to "trimmed/pane_notched.step"
export pane_notched to "trimmed/pane_notched.igs"
export wave_round to "trimmed/wave_round.step"
export wave_round to "trimmed/wave_round.igs"
export wave_rest to "trimmed/wave_rest.step"
export wave_rest to "trimmed/wave_rest.igs"
export dome_touching to "trimmed/dome_touching.step"
export dome_touching to "trimmed/dome_touching.igs"
export wave_half to "trimmed/wave_half.step"
export wave_half to "trimmed/wave_half.igs"
export wave_uv to "trimmed/wave_uv.step"
export wave_uv to "trimmed/wave_uv.igs"
export egg_half to "trimmed/egg_half.step"
export egg_half to "trimmed/egg_half.igs"
export vase_part to "trimmed/vase_part.step"
export vase_part to "trimmed/vase_part.igs"
export vase_hole to "trimmed/vase_hole.step"
export vase_hole to "trimmed/vase_hole.igs"
export plate to "trimmed/plate.step"
export plate to "trimmed/plate.igs"
export thin to "trimmed/thin.step"
export thin to "trimmed/thin.igs"
export leaning to "trimmed/leaning.step"
export leaning to "trimmed/leaning.igs"
export pipe to "trimmed/pipe.step"
export pipe to "trimmed/pipe.igs"
export bend to "trimmed/bend.step"
export bend to "trimmed/bend.igs"
export pear to "trimmed/pear.step"
export pear to "trimmed/pear.igs"
export ball_cut to "trimmed/ball_cut.step"
export ball_cut to "trimmed/ball_cut.igs"
export ball_twice to "trimmed/ball_twice.step"
export ball_twice to "trimmed/ball_twice.igs"
export ball_quarter to "trimmed/ball_quarter.step"
export ball_quarter to "trimmed/ball_quarter.igs"
export log_cut to "trimmed/log_cut.step"
export log_cut to "trimmed/log_cut.igs"
export log_thin to "trimmed/log_thin.step"
export log_thin to "trimmed/log_thin.igs"
export hat_cut to "trimmed/hat_cut.step"
export hat_cut to "trimmed/hat_cut.igs"
export ring_cut to "trimmed/ring_cut.step"
export ring_cut to "trimmed/ring_cut.igs"
export ring_half to "trimmed/ring_half.step"
export ring_half to "trimmed/ring_half.igs"
export pipe_cut to "trimmed/pipe_cut.step"
export pipe_cut to "trimmed/pipe_cut.igs"
export vase_cut to "trimmed/vase_cut.step"
export vase_cut to "trimmed/vase_cut.igs"
export shell to "trimmed/shell.step"
export shell to "trimmed/shell.igs"
export shell_cut to "trimmed/shell_cut.step"
export shell_cut to "trimmed/shell_cut.igs"
export table({
    name: ["ball_cap", "ball_dot", "ball_side", "ball_back", "ball_tilted", "ball_polar", "ball_without", "ball_by_pole", "ball_half", "ball_near_meridian", "ball_belt", "ball_pierced", "ball_window", "ball_leaf", "tube_slant", "tube_steep", "tube_side", "tube_hole", "tube_port", "tube_arcs", "hat_slant", "hat_tip", "hat_parabola", "hat_hyperbola", "hat_hole", "ring_slant", "ring_top", "ring_hole", "ring_port", "elbow_part", "pane_round", "pane_holes", "pane_notched", "wave_round", "wave_rest", "dome_touching", "wave_half", "wave_uv", "egg_half", "vase_part", "vase_hole", "plate", "thin", "leaning", "pipe", "bend", "pear", "ball_cut", "ball_twice", "ball_quarter", "log_cut", "log_thin", "hat_cut", "ring_cut", "ring_half", "pipe_cut", "vase_cut", "shell", "shell_cut"],
    area: [area(ball_cap), area(ball_dot), area(ball_side), area(ball_back), area(ball_tilted), area(ball_polar), area(ball_without), area(ball_by_pole), area(ball_half), area(ball_near_meridian), area(ball_belt), area(ball_pierced), area(ball_window), area(ball_leaf), area(tube_slant), area(tube_steep), area(tube_side), area(tube_hole), area(tube_port), area(tube_arcs), area(hat_slant), area(hat_tip), area(hat_parabola), area(hat_hyperbola), area(hat_hole), area(ring_slant), area(ring_top), area(ring_hole), area(ring_port), area(elbow_part), area(pane_round), area(pane_holes), area(pane_notched), area(wave_round), area(wave_rest), area(dome_touching), area(wave_half), area(wave_uv), area(egg_half), area(vase_part), area(vase_hole), area(plate), area(thin), area(leaning), area(pipe), area(bend), area(pear), area(ball_cut), area(ball_twice), area(ball_quarter), area(log_cut), area(log_thin), area(hat_cut), area(ring_cut), area(ring_half), area(pipe_cut), area(vase_cut), area(shell), area(shell_cut)],
    volume: [0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, 0mm^3, volume(plate), volume(thin), volume(leaning), volume(pipe), volume(bend), volume(pear), volume(ball_cut), volume(ball_twice), volume(ball_quarter), volume(log_cut), volume(log_thin), volume(hat_cut), volume(ring_cut), volume(ring_half), volume(pipe_cut), volume(vase_cut), volume(shell), volume(shell_cut)],
    }) to "trimmed.csv"
