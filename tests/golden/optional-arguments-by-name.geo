// Required arguments stand by position or by name, optional ones by name.
fn frame(width, height, border = 1, label = "plain") = "{label} {width}x{height} {border}"
check frame(2, 3) == "plain 2x3 1"
check frame(height = 3, width = 2) == "plain 2x3 1"
check frame(2, height = 3, border = 4) == "plain 2x3 4"
check frame(2, 3, label = "red") == "red 2x3 1"
// A parameter by name leaves the other one for the position.
check frame(2, width = 5) == "plain 5x2 1"
let c = circle((0, 0), 2, form = "7-triangle")
check circle(radius = 2, center = (0, 0), form = "7-triangle").points == c.points
check len(c.points) == 7
// A default may use other names of the file.
let base = 10
fn shifted(x, by = base) = x + by
check shifted(1) == 11
check shifted(1, by = 2) == 3
