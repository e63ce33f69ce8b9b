geo 1
unit m
// Expected: the same quantities as literals of the language.
table t = load("lib/data/units.csv")
check t.length[0] == 1mm and t.length[1] == none
check t.turn == [90deg, 45deg]
check sin(t.turn[0]) ~= 1
check t.area[0] ~= 100 * 1cm * 1cm within 1e-15
check t.bend[0] == 2 / 1m
check t.um == [1um, 2um] and t.cm == [1cm, 2cm] and t.m == [1m, 2m] and t.km == [1km, 2km]
check t["in"] == [1in, 2in] and t.ft == [1ft, 2ft]
check t.rad == [1rad, 2rad] and t.turns == [1turn, 2turn]
check t["half breadth"] == [7, 8] and t[0]["half breadth"] == 7
// Round brackets tell a unit too; what is none belongs to the name.
table round_brackets = load("lib/data/round-brackets.csv")
check round_brackets.x == [1mm, 3mm] and round_brackets.turn == [90deg, 45deg] and round_brackets.lift == [0.4, 0.5]
check round_brackets["speed (knots)"] == [7, 8] and round_brackets["y, z"] == [2cm, 4cm]
print t.length, t.turn, t.area, t
export t to "back.csv"
