// A table with units, an empty cell and quotation marks; a profile in both usual forms.
table t = load("lib/data/offsets.csv")
check t.x == [1, -30] and t.y == [2.5, none]
check t.name == ["a, \"b\"", "c"]
points foil = load("lib/data/selig.dat")
check foil == load("lib/data/lednicer.dat")
check len(foil) == 5 and foil[1] == (0.5, 0.05)
