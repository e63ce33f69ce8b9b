// The bonnet of a car: a panel over the engine and the drop to the nose, which goes on from it
// without a break in its curvature. One half is drawn; the other is its mirror image.
// x runs forward from the windscreen, y from the middle outward, z upward; in millimetres.

geo 1
unit mm

param drop = 190mm in 60mm..300mm "How far the nose lies below the front of the panel"

// Rows along x. The first two points of a row are level, so that both halves meet smoothly.
surface panel = bezier([
    [(0, 0, 300), (0, 260, 300), (0, 520, 284), (0, 760, 236)],
    [(340, 0, 296), (340, 258, 296), (340, 514, 279), (340, 750, 228)],
    [(680, 0, 280), (680, 252, 280), (680, 500, 262), (680, 728, 210)],
    [(980, 0, 252), (980, 240, 252), (980, 476, 234), (980, 694, 182)],
])

// Three rows of the nose follow from the panel; the last is free.
surface nose = continue_bezier(panel, "u1", 2, [
    [for p in panel.points[3]: p + (430, 0, -drop)],
])

let across = linspace(0, 1, 11)
check every(across, v => nose(0, v) ~= panel(1, v)) "they meet"
check every(across, v => derivative(nose, 0, v) ~= derivative(panel, 1, v)) "with one slope"
check every(across, v => derivative(nose, 0, v, du = 2) ~= derivative(panel, 1, v, du = 2))
    "and one curvature"
check every(across, v => continuity(panel(_, v), nose(_, v)).g >= 2)
print [for v in [0, 0.5, 1]: curvature(panel(_, v), 1) - curvature(nose(_, v), 0)] ~= [0, 0, 0]

// So both are one spline surface with a simple knot between them.
surface half = join([[panel], [nose]])
print half.patches, half.knots_u
check half.knots_u == [0, 0, 0, 0, 1, 2, 2, 2, 2]

// The halves meet with one tangent plane, and as mirror images with one curvature.
surface other = reverse_v(mirror(half, plane((0, 0), (0, 1, 0))))
check every(linspace(0, 2, 9), u => normal(half, u, 0) ~= normal(other, u, 1))
surface bonnet = join([[other, half]])
print bonnet.patches, bonnet.degree_v
check every(linspace(0, 2, 9), u => continuity(bonnet(u, _)).g >= 2) "no crease along the middle"

// The gap to the wings is drawn along the outer sides, the shut line along the border.
curve shut_line = border(bonnet)
check shut_line.closed
print len(wireframe(bonnet, 5, 9))

// Stripes of light lie across the panel: without a kink where panel and nose meet.
curves stripes = zebra(bonnet, (0.3, 0, 1), bands = 24)
print len(stripes)
check not any(stripes, c => any(corners(c), t => c(t).x > 100)) "the stripes have no corner"
export stripes to "car-bonnet-zebra.obj"
