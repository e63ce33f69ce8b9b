// Fairing by hand: the comb of a clamped curve shows a dent that the eye misses; two control points
// moved take it away.

geo 1

param scale = 4 in 1..20 "Length of a tooth where the curvature is 1"

let rough = [(0, 0), (2, 3), (5, 4.2), (8, 3.4), (10, 3.6), (12, 0)]
let faired = [...rough[0..2], (8, 4.2), (10.5, 2.6), (12, 0)]

curve before = clamped(rough)
curve after = clamped(faired)

// The curvature of a hull changes its sign nowhere; that of the first try does.
fn signs(c) = unique([for t in linspace(0, c.domain.end, 101): sign(signed_curvature(c, t))])
print signs(before), signs(after)
check len(signs(before)) > 1 "the first try is dented"
check signs(after) == [-1]

fn highest(c) = max(curvature_table(c).curvature)
print highest(before), highest(after)
check highest(after) < highest(before) "and fairer at its worst place"

let comb_before = curvature_comb(before, samples = 60, scale = scale)
let comb_after = curvature_comb(after, samples = 60, scale = scale)
export before, comb_before.teeth, comb_before.envelope to "before.obj"
export after, comb_after.teeth, comb_after.envelope to "after.obj"
export curvature_table(after, samples = 21) to "after.csv"
