let a = load("data/comma.json")
let b = load("data/curve.json")
