// Digits, units, both; of points, lists and records as of numbers.
unit cm
let width = 12.345cm
let tilt = 33.3333deg
check "{width:.1}" == "12.3cm" and "{width}" == "12.345cm" and "{width / 1cm:.1}" == "12.3" and "{width:mm}" == "123.45mm" and "{width:.1in}" == "4.9in"
check "{width * 2cm:.0mm^2}" == "2469mm^2" and "{1/width:.3 1/m}" == "8.100 1/m"
check "{tilt:.1}" == "33.3deg" and "{tilt:.2rad}" == "0.58rad" and "{tilt}" == "33.3333deg"
check "{(1, 2/3):.2}" == "(1.00, 0.67, 0.00)" and "{[1, 2.5]:.1}" == "[1.0, 2.5]"
check "{{a: 1/3, b: "x"}:.2}" == "\{a: 0.33, b: x\}"
check "{-0.0001:.2}" == "0.00" and "{0.125:.2}{2.5:.0}" == "0.133"
check "{[for i in 0..2: i]:.0}{ {a: 1}.a:.1 }" == "[0, 1, 2]1.0"
check "{if width > 3 then 1/3 else 2:.3}" == "0.333"
check format(width, digits = 2, unit = "mm") == "123.45mm" and format(true) == "true"
check format([for x in [1/3, 2/3]: x], digits = 2) == "[0.33, 0.67]"

// A text that is written as one stands alone; what else is printed has its source before it.
print "width {width:.1mm}, turned by {tilt:.1}"
print width, "a table:", table([for i in 1..3: {name: "frame {i}", at: i * 12.5mm, turn: i * 30deg}])
let told = "kept"
print told

// Rounding, as numbers.
check round(pi, 2) == 3.14 and round(2.675, 2) == 2.68 and round(-1.005, 2) == -1.01
check round(1234.5, -2) == 1200 and round(50, -2) == 100 and round(49, -2) == 0
check round(9.9999, 3) == 10 and round(1e300, 5) == 1e300 and round(0.1 + 0.2, 15) == 0.3
check round(width, 1) == 12.3cm

// Texts taken apart and put together.
check split("x;y;;z", ";") == ["x", "y", "", "z"] and split(" a  b ") == ["a", "b"]
check join(split("x;y", ";"), "-") == "x-y" and join([], ",") == ""
check substring("größer", 2, 4) == "öß" and substring("abc", -2) == "bc" and substring("abc", 2, 1) == ""
check index_of("größer", "ß") == 3 and index_of("a", "b") == none
check contains("bow.geo", ".geo") and not contains("bow", "stern")
check replace("a-b-c", "-", "") == "abc" and upper("maß") == "MASS" and lower("ÄB") == "äb"
check pad("7", 3) == "  7" and pad("7", 3, side = "right", fill = ".") == "7.." and pad("long", 2) == "long"

// Lists.
check argmin([3, 1, 2, 1]) == 1 and argmax(["b", "c", "a"]) == 1
check argmax([(0, 5), (0, 9)], by = p => p.y) == 1
check flatten([[1, [2, [3]]], 4], 2) == [1, 2, [3], 4] and flatten([[1]], 0) == [[1]] and flatten([[[1]]], 99) == [1]
check contains([1, 2], 2) and index_of([(0, 0), (1, 0)], (1, 0)) == 1 and index_of(3..5, 9) == none
