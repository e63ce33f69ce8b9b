curve c = line((0, 0), (1, 1))
export report to "all.obj"
export c to "c.html"
export report, c to "both.md"
export report to "a.md" with (pictures = false)
export report to "b.md" with (title = "", picture = "front")
export report to "c.pdf"
