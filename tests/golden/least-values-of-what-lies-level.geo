// What falls to where it lies level, as penalties do, is least there; what comes to zero is least there, however far it fell.
geo 1

let hinge = minimize(u => max(0, 1 - (u.a - 2)^2) + 3, start = {a: 2.2}, report = true)
check hinge.value == 3
let ridge = maximize(u => min(0, (u.a - 2)^2 - 1), start = {a: 2.2}, report = true)
check ridge.value == 0

let step = minimize(u => if u.a > 3 then (u.a - 3)^8 + 2 else 2, start = {a: 50}, report = true)
check step.value == 2

let quartics = minimize(p => (p.x - 1)^4 + (p.y - 2)^4 + p.z^4, start = (50, 50, 50), report = true)
check quartics.value < 1e-15 and quartics.evaluations < 400
