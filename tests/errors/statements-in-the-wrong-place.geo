let a = 1
geo 1
unit mm
unit cm
let b = { print 1  2 }
