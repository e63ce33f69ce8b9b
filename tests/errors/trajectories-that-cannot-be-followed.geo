unit mm
// Without bound at 1.
curve hyperbola = ode((t, p) => (p.x^2, 0), start = (1, 0), range = 0..2)
// Stiff, chaotic, trapped.
curve stiff = ode((t, p) => (-1e6 * (p.x - 1), 0), start = (1.1, 0), range = 0..10)
curve weather = ode((t, p) => (10*(p.y - p.x), p.x*(28 - p.z) - p.y, p.x*p.y - 8/3*p.z), start = (1, 1, 1), range = 0..100)
// Functions that do not fit.
curve counted = ode(p => (-p.y, p.x), start = (1, 0), range = 0..1)
curve of_numbers = ode((t, p) => t, start = (1, 0), range = 0..1)
let of_one = ode((t, s) => s[0], start = [(1, 0), (0, 1)], range = 0..1)
let of_three = ode((t, s) => [s[0], s[0], s[1]], start = [(1, 0), (0, 1)], range = 0..1)
let of_mixed = ode((t, s) => [s[0], 1], start = [(1, 0), (0, 1)], range = 0..1)
// Starts and ranges.
let numbers = ode((t, s) => [s[1], -s[0]], start = [0, 1], range = 0..1)
let nothing = ode((t, s) => s, start = [], range = 0..1)
curve backwards = ode((t, p) => (1, 0), start = (0, 0), range = 3..0)
curve endless = ode((t, p) => (1, 0), start = (0, 0), range = 0..1/0)
curve mixed = ode((t, p) => (1, 0), start = (0, 0), range = 0mm..90deg)
curve exactly = ode((t, p) => (1, 0), start = (0, 0), range = 0..1, tolerance = 0)
// Where the function has no value: at the start, and on the way.
curve at_start = ode((t, p) => (1 / p.x, 0), start = (0, 0), range = 0..1)
curve on_the_way = ode((t, p) => (-sqrt(p.x), 1 / (0.5 - t)), start = (1, 0), range = 0..1)
curve outside = ode((t, p) => (-1, sqrt(p.x)), start = (1, 0), range = 0..2)
// Units that do not fit, and derivatives.
curve units = ode((t, p) => (p.x + t, 0), start = (0, 0), range = 0deg..90deg)
// What never ends.
fn endless_call(t, p) = endless_call(t, p)
curve forever = ode(endless_call, start = (0, 0), range = 0..1)
