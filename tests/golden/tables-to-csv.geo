table offsets = table({ x: linspace(0, 1, 3), name: ["bow", "mid, \"ship\"", "stern"] })
table rows = table([for i in 0..2: { i: i, square: i^2 }])
print offsets, len(rows), rows[1], rows.square
check rows.square == [0, 1, 4]
check rows[-1] == { i: 2, square: 4 }
check offsets.name[0] == "bow"
export offsets to "offsets.csv"
export rows to "below/rows.csv"
