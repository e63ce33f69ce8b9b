fn safe(r) = { let ok = assert(r > 0, "the radius {r} is not positive") r }
let a = safe(2)
let b = safe(-2)
