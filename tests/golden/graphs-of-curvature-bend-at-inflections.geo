// Where a plane curve has an inflection, the graph of its curvature has a kink: it is measured and drawn with it.
curve k = bezier((0, 0), (1, 2), (3, 0), (4, 1))
let bend = inflections(k)[0]
curve graph = parametric(t => (t, curvature(k, t) / 1mm^-1), 0..1)
check length(graph) > 1mm
check graph(bend).y ~= 0 within 1e-9
check length(graph) ~= length(graph, range = 0..bend) + length(graph, range = bend..1) within 1e-6

// Others of the same kind, with and without inflections.
let bends = [for i in 0..8: bezier((0, 0), (1, 2 - i / 3), (3, i / 5 - 1), (4, 1))]
let lengths = [for c in bends: length(parametric(t => (t, curvature(c, t) / 1mm^-1), 0..1))]
check every(lengths, l => l >= 1mm)

// By hand, on the side where the curve turns: beside the inflection it is on the other one.
let offset_before = parametric(t => k(t) + 0.1 * normal(k, t), 0..(bend - 0.01))
check distance(offset_before(0.2), k(0.2)) ~= 0.1 within 1e-12
print len(bends)
export graph to "graph.obj"
