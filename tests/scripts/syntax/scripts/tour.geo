geo 1                                                   // the edition of the language
unit mm

param neck = 13mm in 8mm..20mm step 0.5mm "Neck radius" // virote run bottle.geo --set neck=15mm
param body = 34mm

/// Radius of the section at height h, 0 at the foot and 1 at the mouth.
fn radius(h) = body + (neck - body) * (3*h^2 - 2*h^3)

curves  rings    = [for h in linspace(0, 1, 5): circle((0, 0, 90*h), radius(h))]
surface shoulder = skin(rings)
curve   profile  = shoulder(0, _)                       // the isocurve u = 0

check continuity(rings[0]).g >= 2      "the ring closes without a corner"
check max(curvature_table(profile).curvature) < 1/5mm   "no bend tighter than 5 mm"
print area(shoulder), length(profile)

export shoulder                  to "shoulder.glb" with (tolerance = 0.05)
export curvature_table(shoulder) to "shoulder.csv"
export all to "x.obj"
curve bezier((0,0), (1,2), (2,0))
let [a, b] = f(x) with (color = "#6688aa")
let {k1, k2} = { a: 1, b, c: -2^-1 }
import "a.geo" as q with (n = 3)
import "b.geo" (a, b)
test "it {1 + {a: 2}.a} works" {
  let p = 1; check p == 1
  expect error "E0203" let_(3)
}
let bb = { let a = 1  fn f(x) = x  curve c = line((0,0), (1,0))  c(f(a)) }
let z = [for [i, j] in xs if i < 2, k in 0..<3: (i, j, k)] |> map(x => x.y.to)
let y = if a ~= b within 1e-9 and not c then (u, v) => u else table({x: [1], y: [...xs, 2]})
