// Another script is an expression: in functions and comprehensions its parameters depend on anything.
geo 1
let base = script("lib/hull.geo", beam = 4)
fn plane(b) = script("lib/hull.geo", beam = b).waterplane
let {keel, waterplane} = script("lib/hull.geo", length = 6, beam = 2)
check base.waterplane ~= 80/3
check base.half(5) ~= 1.5 "a function of the file with the parameters that were given"
check [for b in [1, 2, 3]: plane(b)] ~= [20/3, 40/3, 20]
check solve(b => plane(b) - 25, within = 2..5) ~= 3.75
check gradient(plane, 3) ~= 20/3 "derivatives pass through the file"
check keel.end == (6, 0) and waterplane ~= 8
check ("lib/hull.geo" |> script(beam = 3)).half(0) == 1.5
check { fn script(path) = path; script("no file") } == "no file"
print plane(3), base

test "what cannot be had is told" {
    expect error "E0701" script("lib/missing.geo")
    expect error "E0801" script("lib/hull.geo", beem = 3)
    expect error "E0802" script("lib/hull.geo", beam = 7)
    expect error "E0401" script("lib/hull.geo", beam = 2, beam = 3)
}
