let base = import "hull.geo" with (beam = 5m, parts = [1, (2, 3)])
let other = import "hull.geo"
let rows = import "rows.csv"
