let corners = [(0, 0), (1, 0)]
curve a = line((0, 0), (1, 0))
curve b = line((0, 0), (0, 1))
export a, b, translate(a, (0, 0, 1)) to "three.json"
export [for i in 0..2: {i, square: i^2}] |> table() to "squares.csv"
let name = "file-{1 + 1}"
export corners to "{name}.json"
