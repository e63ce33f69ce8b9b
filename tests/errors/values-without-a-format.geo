curve c = line((0, 0), (1, 0))
point p = (0, 0)
table t = table({x: [1, 2]})
mesh m = grid_mesh(sphere((0, 0), 1), 3, 3)
export c to "a.stl"
export t to "b.stl"
export t to "c.svg"
export p to "d.csv"
export m to "e.csv"
export [c, t] to "f.svg"
export { a: 1 } to "g.svg"
export c to "h.svgg"
export c to "i.xyz"
