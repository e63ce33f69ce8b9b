geo 1
// Nesterov's function falls along the kinks of its bends, where the gradients beside its corner at (0, -1) hold zero
// between them: its one least value is at (1, 1).
fn nesterov(v) = abs(v[0] - 1)/4 + abs(v[1] - 2*abs(v[0]) + 1)
let found = minimize(nesterov, start = [-1, 1])
check nesterov(found) < 1e-9
check found ~= [1, 1] within 1e-9
