// First steps: a curve, some questions, a few claims, a file.
//
//     virote run first-steps.geo
//
// A script declares things; it does not do them one after another. Every definition
// begins with a keyword that says what it is, and the order does not matter.

geo 1
unit mm

/// Three control points make a parabola: it starts at the first, ends at the last,
/// and is drawn towards the one between them.
curve arch = bezier((0, 0), (40, 60), (80, 0))

// Questions. `arch(t)` is the point at the parameter t, which runs from 0 to 1 here.
print arch.degree
print arch(0.5)
print tangent(arch, 0)

// `let` names any value.
let top = arch(0.5)

// Claims. If one does not hold, the report shows both sides and by how much it misses,
// and the command ends with exit code 1.
check top ~= (40, 30)                                     "a parabola peaks at half the height of its middle point"
check arch.start ~= (0, 0) and arch.end ~= (80, 0)        "it stands on its two feet"
check dot(tangent(arch, 0.5), (0, 1)) ~= 0                "it is level at the top"
check bounds(arch).max.y ~= top.y                         "no point of it is higher"

// A function of the script, and a list made with it.
fn height(t) = arch(t).y
let heights = [for t in linspace(0, 1, 5): height(t)]
print heights
check heights ~= [0, 22.5, 30, 22.5, 0]

// Files. The ending chooses the format.
export arch to "arch.obj"
export table([for t in linspace(0, 1, 11): {t, x: arch(t).x, y: arch(t).y}]) to "arch.csv"
