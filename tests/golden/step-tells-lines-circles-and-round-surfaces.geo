// What is a line, circle, plane, cylinder, cone, sphere or torus is written as that; a ball that was
// moved, refined and cut too, a ball that was stretched not.
unit cm
curve edge = line((0, 0, 0), (3, 4, 0)) with (color = "red", layer = "wires")
curve bend = arc((0, 0), 2, 0deg, 90deg)
curve rim = circle((5, 0), 1)
surface bore = flip(cylinder((0, 0, 0), 1, 2)) with (color = "#336699", layer = "holes")
surface dome = trim(
    insert_knot(elevate(translate(sphere((0, 0, 0), 2), (9, 0, 1)), u = 3), v = 0.3),
    v = 0.5..1,
)
surface funnel = trim(cone((20, 0, 0), 3, 0, 4), u = 0..0.5)
surface washer = ruled(circle((30, 0, 0), 1), circle((30, 0, 0), 2))
surface elbow = revolve(circle((5, 0, 0), 1, normal = (0, 1, 0)), axis = (0, 0, 1), angle = 90deg)
surface egg = scale(trim(trim(sphere((0, 0, 0), 1), u = 0..0.25), v = 0.5..1), (1, 1, 1.5))
export edge, bend, rim to "wires.step"
export bore to "bore.step"
export dome to "dome.step"
export funnel to "funnel.step"
export washer to "washer.step"
export elbow to "elbow.step"
export egg to "egg.step"
