// Surfaces with seams, poles, apexes and corners, rational and not, one a name.
unit mm
surface patch = bezier([[(0, 0, 0), (0, 5, 2), (0, 10, 0)], [(5, 0, 3), (5, 5, -4), (5, 10, 1)], [(10, 0, 0), (10, 5, 2), (10, 10, 0)], [(15, 0, 1), (15, 5, 0), (15, 10, 2)]]) with (color = "#6688aa", layer = "hull")
surface tube = cylinder((20, 0, 0), 3, 10) with (color = "orange")
surface ball = sphere((30, 0, 0), 4) with (layer = "hull")
surface ring = torus((45, 0, 0), 6, 2)
surface hat = cone((60, 0, 0), 5, 0, 8)
surface flat = plane_patch((0, 20, 0), (4, 0, 0), (0, 3, 1))
surfaces crate = box((10, 20, 0), (3, 4, 5)) with (color = "darkred")
surface slope = ruled(arc((30, 20, 0), 4, 0deg, 120deg), line((28, 25, 6), (33, 28, 6)))
surface web = interpolate([for i in 0..5: [for j in 0..5: (40 + i, 20 + j, sin(0.7 * i) * cos(0.5 * j))]])
surface half = nurbs([[(50, 20, 0), (50, 24, 0)], [(52, 20, 3), (52, 24, 3)], [(54, 20, 0), (54, 24, 0)]], weights = [[1, 1], [0, 0], [1, 1]], degree = {u: 2, v: 1})
surface leaf = coons_bspline([for i in 0..4: [for j in 0..4: (60 + 2 * i, 20 + 2 * j, i * j / 4)]])
surface disk = disc(plane((0, 40, 0), normal = (1, 2, 3)), 3)
surface washer = ruled(circle((10, 40, 0), 2), circle((10, 40, 0), 4))
surface dome = trim(sphere((20, 40, 0), 4), v = 0.8..1)
surface zone = trim(trim(sphere((30, 40, 0), 4), u = 0.1..0.6), v = 0.2..0.9)
surface elbow = translate(revolve(rotate(circle((5, 0, 0), 1, normal = (0, 1, 0)), 50deg, axis = (0, 1, 0), about = (5, 0, 0)), axis = (0, 0, 1), angle = 90deg), (35, 38, 0))
surface fillet = translate(revolve(arc((5, 0, 0), 1, -60deg, 60deg, normal = (0, -1, 0)), axis = (0, 0, 1), angle = 200deg), (50, 40, 0))
surface funnel = trim(cone((60, 40, 0), 5, 2, 4), u = 0.1..0.7)
surface bore = flip(extrude(circle((70, 40, 0), 2), (0, 0, -7)))
surface gutter = swap_uv(extrude(arc((0, 50, 0), 2, 20deg, 300deg), (0, 0, 7)))
surface moved = rotate(translate(scale(elevate(insert_knot(sphere((1, 2, 3), 4), u = 0.3), u = 4), 0.5), (10, 50, 7)), 33deg, axis = (1, 2, 3))
surface oval = scale(sphere((20, 50, 0), 2), (1, 1, 1.5))
surface twisted = ruled(circle((30, 50, 0), 2), rotate(circle((30, 50, 4), 2), 20deg, about = (30, 50, 0)))
surface wave = parametric((u, v) => (70 + u, 20 + v, sin(u) * cos(v)), 0..3, 0..2)
export all to "solids.step"
export all to "solids.igs"
export all to "solids.stl"
export all to "solids-text.stl" with (binary = false)
export all to "solids.ply"
export all to "solids-text.ply" with (binary = false)
export all to "solids.glb"
export all to "solids.gltf"
export all to "solids.dxf"
export all to "solids.obj"
export all to "solids-exact.obj" with (free_form = true)
export all to "solids.svg" with (view = "isometric")
export patch, tube, ball, ring, hat, flat, crate, slope, web, half, leaf, disk, washer, dome, zone, elbow, fillet, funnel, bore, gutter, moved, oval, twisted to "solids.json"
export check_places to "solids.csv"
table check_places = table([for s in [patch, tube, ball, ring, hat, flat, slope, web, half, leaf]: { x: s(s.domain_u.start * 0.7 + s.domain_u.end * 0.3, s.domain_v.start * 0.4 + s.domain_v.end * 0.6).x, y: s(s.domain_u.start * 0.7 + s.domain_u.end * 0.3, s.domain_v.start * 0.4 + s.domain_v.end * 0.6).y, z: s(s.domain_u.start * 0.7 + s.domain_u.end * 0.3, s.domain_v.start * 0.4 + s.domain_v.end * 0.6).z }])
