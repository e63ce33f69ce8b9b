let name = "lib/circle"
let a = script("{name}.geo")
let b = script("lib/missing.geo")
let c = script("a-script-that-cannot-be-called-so.geo")
let d = map([1, 2], script)
let e = script(radius = 2)
