let a = load("data/letters.obj")
let b = load("data/index.obj")
let c = load("data/empty.obj")
