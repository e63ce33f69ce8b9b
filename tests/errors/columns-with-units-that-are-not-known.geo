let a = load("data/kilograms.csv")
let b = load("data/lettered.csv")
let t = load("data/words.csv")
print t["half bredth"]
print t["station"]
