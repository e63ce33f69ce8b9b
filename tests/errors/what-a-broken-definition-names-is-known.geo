param stations: integer = in 11..501
fn beside(t) = t + = 1
surface foot = ruled(line((0, 0), (1, 0)), line((0, 1
print stations, beside(1), bounds(foot)
