// Offsets of surfaces that break other programs, by name.

test "a sphere, its poles too" {
  let ball = offset(sphere((1, 2, 3), 5), 0.5, 1e-6)
  check every([for u in [0, 0.3, 0.99], v in [0, 0.2, 0.5, 1]: norm(ball(u, v) - (1, 2, 3))], r => r ~= 5.5 within 1e-9)
}

test "a surface whose curvature changes its sign" {
  let wave = bezier([for i in 0..3: [for j in 0..3: (i, j, 0.4*[0, 1, -1, 0][i]*[1, -1, 1, -1][j])]])
  let beside = offset(wave, 0.2, 1e-5)
  let at = [for u in [0.05, 0.3, 0.5, 0.8], v in [0.1, 0.45, 0.7, 0.95]: beside(u, v)]
  check every(at, p => closest(wave, p).distance ~= 0.2 within 1e-5)
}

// OCCT 1486: an offset by more than the least radius gives the original in silence.
test "beyond the least radius it is not the surface itself" {
  let pipe = cylinder((0, 0), 1, 2)
  check distance(offset(pipe, -0.75, 1e-6)(0.1, 0.5), (0, 0, 1)) ~= 0.25 within 1e-9
}
