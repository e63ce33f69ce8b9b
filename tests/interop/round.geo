// Circles, arcs, and paths of arcs and lines, which formats of drawings have words of their own for.
unit cm
curve slanted = rotate(circle((60, 20), 3), 50deg, axis = (1, 2, 0), about = (60, 20, 0))
curve below = rotate(circle((60, 30, 2), 2), 180deg, axis = (1, 0, 0), about = (60, 30, 0))
curve turned = rotate(arc((70, 20), 3, 200deg, -20deg), 130deg, axis = (2, -1, 1), about = (70, 20, 0))
curve slot = rotate(join([line((0, 30), (4, 30)), arc((4, 31), 1, -90deg, 90deg), line((4, 32), (0, 32)), arc((0, 31), 1, 90deg, 270deg)]), 25deg, about = (2, 31, 0))
curve hook = join([line((10, 30), (14, 30)), arc((14, 31), 1, -90deg, 60deg)])
curve raised = rotate(translate(hook, (10, 0, 5)), 70deg, axis = (0, 1, 1), about = (20, 30, 5))
export all to "round.dxf"
export all to "round.json"
