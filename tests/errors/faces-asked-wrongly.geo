geo 1

let corners = [(0, 0), (1, 1), (1, 0), (0, 1)]
let beyond = mesh(corners, [[0, 1, 2], [0, 3, 7]])
let twice = mesh(corners, [[0, 1, 2, 1]])
let few = mesh(corners, [[0, 1, 2], [0, 1]])
let none_at_all = mesh(corners, [[]])
let half = mesh(corners, [[0, 1, 2], [0, 1.5, 2]])
let below = mesh(corners, [[0, -1, 2]])
let measured = mesh(corners, [[0, 1mm, 2]])
let word = mesh(corners, [[0, 1, "two"]])
let huge = mesh(corners, [[0, 1, 1e30]])
let crossing = mesh(corners, [[0, 1, 2, 3]])
let list = [[0, 1, 2], [0, 1, 9]]
let named = mesh(corners, list)
let flat = mesh(corners, [0, 1, 2])
