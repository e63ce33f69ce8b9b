unit m
check 14.3239deg < 10deg
check length(line((0, 0), (3, 4))) ~= (0, 7, 0).y
let radii = [for i in 1..6: {name: "r{i}", r: i * 1m}]
check every(radii, row => row.r < 4m)
check every(radii, row => row.r ~= 1 within 0.5m)
check every(radii, row => { let d = 2 * row.r
  d <= 3m and row.name != "r9" })
check any(radii, row => row.r > 8m)
check not any(radii, row => row.r > 5m)
check every([for row in radii: row.r < 3m])
check radii[0].name != "r1"
check [] != []
check { let a = 3m; a > 4m }
