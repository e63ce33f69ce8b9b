x := 3
let y = 1e400 mm
