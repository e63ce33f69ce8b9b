let a = load("data/letters.bpt")
let b = load("data/short.bpt")
let c = load("data/long.bpt")
