let a = {
  let b = 1
  b
let c = 2
print c
