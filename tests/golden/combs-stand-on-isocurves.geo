// The comb of an isocurve is that of the curve in space.
let ball = sphere((0, 0), 5)
// Meridians of a sphere are circles with its radius: teeth of length 1/5 along the normal.
let meridians = curvature_comb(ball, u = [0, 0.3], samples = 7)
check [len(meridians.teeth), len(meridians.envelopes)] == [14, 2]
check every(meridians.teeth, a => norm(a.start) ~= 5 within 1e-12)
check every(meridians.teeth, a => a.end ~= a.start*(1 + 1/25) within 1e-12)
// A circle of latitude at distance ρ from the axis: teeth of length 1/ρ away from the axis, and not
// along the normal of the sphere.
let latitudes = curvature_comb(ball, v = [0.3, 0.5, 0.6], samples = 9, scale = 2)
fn outward(p) = (p.x, p.y)/(p.x^2 + p.y^2)
check every(latitudes.teeth, a => a.end ~= a.start + 2*outward(a.start) within 1e-12)
// The envelope goes through the tips, at the parameters of the teeth.
let second = meridians.envelopes[1]
let steps = linspace(second.domain.start, second.domain.end, 7)
check [for t in steps: second(t)] ~= [for i in 7..13: meridians.teeth[i].end] within 1e-12

// Of a cylinder circles have teeth of length 1/r, and straight lines teeth without length.
let pipe = cylinder((0, 0), 2, 5)
check every(curvature_comb(pipe, v = [0, 0.5, 1], samples = 5).teeth, a => norm(a.end - a.start) ~= 1/2 within 1e-12)
check every(curvature_comb(pipe, v = [0.5], samples = 5, side = "inside").teeth, a => hypot(a.end.x, a.end.y) ~= 1.5 within 1e-12)
check every(curvature_comb(pipe, u = [0, 0.25], samples = 5).teeth, a => a.end ~= a.start within 1e-12)
// It is the comb of the isocurve.
check [for a in curvature_comb(pipe, v = [0.5], samples = 5).teeth: a.end] == [for a in curvature_comb(pipe(_, 0.5), samples = 5).teeth: a.end]

// Without parameters those that a picture draws: nine lines each way, a seam once and no pole.
check len(curvature_comb(plane_patch((0, 0), (1, 0), (0, 1)), samples = 2).envelopes) == 18
check len(curvature_comb(pipe, samples = 2).envelopes) == 8 + 9
check len(curvature_comb(ball, samples = 3).envelopes) == 8 + 7
check len(curvature_comb(parametric((u, v) => (u, v, u*v), 0..1, 0..1), samples = 3).envelopes) == 18
