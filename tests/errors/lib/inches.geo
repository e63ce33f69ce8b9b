unit in
let width = 2
