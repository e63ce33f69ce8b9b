let total = sum(0..100000000)
let more = linspace(0, 1, 100000000)
