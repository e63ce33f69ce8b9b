unit mm
// Written in metres, taken as it stands, with a warning.
mesh block = load("lib/block-in-metres.obj")
check volume(block) ~= 6
// A comma in quotation marks separates nothing.
let t = load("lib/quoted.csv")
check t["a,b"] == [1.5, 3] and t.c == [2, 4]
// One within a cell marks inches, and nothing else.
let inches = load("lib/inches.csv")
check inches["d \""] == [1] and inches["w \""] == [2]
