let x = 3mm
print "{x:.3f}"
print "{x:kg}"
print "{x:}"
print "{x:>8}"
print "{x:.}"
print "{x:.999}"
print "{x:deg}"
print "{30deg:mm}"
print "{line((0, 0), (1, 0)):.2}"
print "{x mm}"
print format(x, digits = -1)
print format(x, digits = 1.5)
print pad("a", 1e9)
print argmin([])
print argmax([1, "a"])
print substring("abc", 7)
print split("abc", "")
print round(2deg, 3)
print round(2, 0.5)
