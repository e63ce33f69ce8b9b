let f = x => x + 1
let g = f
check f == g and not (f != g)
check f != (x => x + 1) "two functions that say the same"
check sin == sin and sin != cos
let h = sin
check h == sin and h != f
check [f, sin] == [g, h] and {f: f} != {f: sin}
