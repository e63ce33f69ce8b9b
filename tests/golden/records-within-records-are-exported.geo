// Geometry is written however deep it lies in records and lists; what else a record tells is left out.
curve c = line((0, 0), (1, 0))
let told = {c, note: "one", inner: {a: translate(c, (0, 1)), n: 2}, list: [{k: 1, a: translate(c, (0, 2))}], log: [none, "x", translate(c, (0, 3))]}
export told to "told.obj"
