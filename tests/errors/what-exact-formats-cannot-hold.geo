mesh m = grid_mesh(sphere((0, 0), 1), 3, 3)
export m to "a.step"
export m to "b.igs"
export table({x: [1]}) to "c.dxf"
