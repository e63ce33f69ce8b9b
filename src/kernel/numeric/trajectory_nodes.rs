//! What a trajectory comes to, at its nodes and between them.

/// A state over a range: between its nodes the quintics that have its value and two derivatives there.
///
/// ```
/// use virote_kernel::{TrajectoryError, find_trajectory};
///
/// // y' = y grows to e.
/// let found = find_trajectory(|_, y| Ok::<_, ()>(y.to_vec()), &[1.0], [0.0, 1.0], 1e-9)?;
/// assert!((found.at(1.0)[0] - std::f64::consts::E).abs() < 1e-9);
/// assert!(found.error < 1e-9);
/// # Ok::<(), TrajectoryError<()>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Trajectory {
    /// Two or more, in the order of the range.
    pub nodes: Vec<TrajectoryNode>,
    /// How far it is at most from one with larger errors in each step: more than it is off by itself.
    pub error: f64,
    /// How often the rate was asked for.
    pub n_evaluations: usize,
    /// Beside which places it may jump, since its rate goes another way between.
    pub(super) jumps: Vec<[f64; 2]>,
}

/// A place of a trajectory.
///
/// ```
/// use virote_kernel::{TrajectoryError, TrajectoryNode, find_trajectory};
///
/// let found = find_trajectory(|t, _| Ok::<_, ()>(vec![2.0 * t]), &[0.0], [0.0, 1.0], 1e-9)?;
/// let TrajectoryNode { place, rate, second, .. } = &found.nodes[1];
/// assert!((rate[0] - 2.0 * place).abs() < 1e-12 && (second[0] - 2.0).abs() < 1e-9);
/// # Ok::<(), TrajectoryError<()>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct TrajectoryNode {
    /// Where in the range.
    pub place: f64,
    /// The state.
    pub state: Vec<f64>,
    /// Its first derivative.
    pub rate: Vec<f64>,
    /// Its second derivative.
    pub second: Vec<f64>,
}

impl Trajectory {
    /// The state at a place; beyond the range the first and last quintic go on. That of its only node, if it has one.
    #[must_use]
    pub fn at(&self, place: f64) -> Vec<f64> {
        if let [] | [_] = self.nodes[..] {
            return self.nodes.first().map(|node| node.state.clone()).unwrap_or_default();
        }
        let (a, b, width) = self.nodes_beside(place);
        let s = (place - a.place) / width;
        let [to_a, to_b] = [quintics(1.0 - s), quintics(s)];
        let state = |i: usize| {
            to_a[0] * a.state[i]
                + to_b[0] * b.state[i]
                + width * (to_b[1] * b.rate[i] - to_a[1] * a.rate[i])
                + width * width * (to_a[2] * a.second[i] + to_b[2] * b.second[i])
        };
        let parts = [&a.state, &a.rate, &a.second, &b.state, &b.rate, &b.second];
        let n_components = parts.iter().map(|part| part.len()).min().unwrap_or(0);
        (0..n_components).map(state).collect()
    }

    /// Its derivative there.
    pub(super) fn rate_at(&self, place: f64) -> Vec<f64> {
        let (a, b, width) = self.nodes_beside(place);
        let s = (place - a.place) / width;
        let [to_a, to_b] = [slopes_of_quintics(1.0 - s), slopes_of_quintics(s)];
        let rate = |i: usize| {
            (to_b[0] * b.state[i] - to_a[0] * a.state[i]) / width
                + to_b[1] * b.rate[i]
                + to_a[1] * a.rate[i]
                + width * (to_b[2] * b.second[i] - to_a[2] * a.second[i])
        };
        (0..a.state.len()).map(rate).collect()
    }

    /// The nodes between which a place is, or the first or last two, and how far they are apart.
    fn nodes_beside(&self, place: f64) -> (&TrajectoryNode, &TrajectoryNode, f64) {
        let behind = self.nodes.partition_point(|node| node.place <= place);
        let behind = behind.clamp(1, self.nodes.len() - 1);
        let (a, b) = (&self.nodes[behind - 1], &self.nodes[behind]);
        (a, b, b.place - a.place)
    }

    /// Where two differ most at the nodes of the other one and halfway between, by how much, and how large they
    /// are. Between a jump of the one and the same jump of the other nothing is compared.
    pub(super) fn apart(&self, other: &Self) -> (f64, f64, f64) {
        if self.jumps.len() != other.jumps.len() {
            let first =
                self.jumps.iter().zip(&other.jumps).find(|(a, b)| a[1] < b[0] || b[1] < a[0]);
            let longer = if self.jumps.len() < other.jumps.len() { other } else { self };
            let jump = first.map(|(a, _)| a).or_else(|| longer.jumps.last());
            return (jump.map_or(f64::NAN, |jump| jump[0]), f64::INFINITY, 0.0);
        }
        let is_at_jump = |place: f64| {
            let behind = other.jumps.partition_point(|jump| jump[1] < place);
            let beside = behind.saturating_sub(1)..(behind + 1).min(other.jumps.len());
            let mut pairs = self.jumps[beside.clone()].iter().zip(&other.jumps[beside]);
            pairs.any(|(a, b)| a[0].min(b[0]) <= place && place <= a[1].max(b[1]))
        };
        let (mut at, mut error, mut size) = (f64::NAN, 0.0_f64, 0.0_f64);
        let middles = other.nodes.windows(2).map(|pair| 0.5 * (pair[0].place + pair[1].place));
        let places = other.nodes.iter().map(|node| node.place).chain(middles);
        for place in places.filter(|place| !is_at_jump(*place)) {
            for (a, b) in self.at(place).iter().zip(other.at(place)) {
                size = size.max(b.abs());
                if error < (a - b).abs() || !(a - b).is_finite() {
                    (at, error) = (place, (a - b).abs());
                }
            }
        }
        (at, error, size)
    }
}

/// The quintics over 0..1 that vanish with two derivatives at 0, and of which at 1 the value, the first, or
/// the second derivative is 1, and the others 0.
fn quintics(s: f64) -> [f64; 3] {
    let cube = s * s * s;
    [
        cube * (10.0 - 15.0 * s + 6.0 * s * s),
        cube * (-4.0 + 7.0 * s - 3.0 * s * s),
        0.5 * cube * (1.0 - 2.0 * s + s * s),
    ]
}

/// Their derivatives.
fn slopes_of_quintics(s: f64) -> [f64; 3] {
    let square = s * s;
    [
        30.0 * square * (1.0 - s) * (1.0 - s),
        square * (-12.0 + 28.0 * s - 15.0 * square),
        0.5 * square * (3.0 - 8.0 * s + 5.0 * square),
    ]
}

#[cfg(test)]
mod tests {
    use super::{quintics, slopes_of_quintics};

    #[test]
    fn quintics_are_those_of_hermite() {
        // s⁵ has the value 1 at 1, the slope 5 and the second derivative 20, and none of these at 0.
        for s in [0.0, 0.3, 0.5, 0.9, 1.0] {
            let [value, slope, second] = quintics(s);
            assert!((value + 5.0 * slope + 20.0 * second - s * s * s * s * s).abs() < 1e-15);
        }
    }

    #[test]
    fn slopes_of_quintics_are_their_differences() {
        for s in [0.1, 0.3, 0.5, 0.9] {
            let [low, high] = [quintics(s - 1e-4), quintics(s + 1e-4)];
            for (slope, (low, high)) in slopes_of_quintics(s).iter().zip(low.iter().zip(high)) {
                assert!((slope - (high - low) / 2e-4).abs() < 1e-6, "{slope}");
            }
        }
    }
}
