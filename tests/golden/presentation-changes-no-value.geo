curve shown = line((0, 0), (1, 0)) with (color = "#6688aa", layer = "hull")
curve concealed = line((0, 0), (0, 1)) with (hidden = true)
let construction = line((0, 0), (1, 1))
print shown, concealed
export all to "shown-only.json"
export concealed to "asked-for.json"
check concealed.end == (0, 1)
