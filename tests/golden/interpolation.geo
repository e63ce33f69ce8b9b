let i = 2
let name = "frame"
print "{name} {i + 1}", "a\tb\n\"c\" \\ \{ \u{e9}", "{[1, 2]} {(0, 1)} {30deg} {true}", "nested {"x{i}y"}"
check "frame {i + 1}" == "frame 3"
check "{name}{name}" == "frameframe"
check "{0.1 + 0.2}" == "0.30000000000000004"
check str(1.5) == "1.5"
check num("2.5") == 2.5
check "\u{41}\u{1F600}" == "A😀"
check len("") == 0
