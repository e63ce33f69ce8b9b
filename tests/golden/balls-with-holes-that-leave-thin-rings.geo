// What a hole through the middle leaves of a ball depends on its height alone: pi*h^3/6, however thin it is.
geo 1

fn ring(h) = {
  let radius = sqrt(4 - h^2 / 4)
  let ball = sphere((0, 0), 2)
  let hole = cylinder((0, 0, -3), radius, 6)
  solid([trim(ball, by = hole, keep = (2, 0, 0)), trim(hole, by = ball, keep = (radius, 0, 0))])
}
let rings = [for h in [0.1, 0.5]: volume(ring(h)) / (pi * h^3 / 6 * 1mm^3)]
check rings ~= [1, 1] within 1e-4
