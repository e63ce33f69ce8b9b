//! What a state comes to that changes at a known rate: initial values of ordinary differential equations.

use super::dormand_prince::{Step, Trial};
use crate::{
    ceiling::{TRAJECTORY_REFINEMENTS, TRAJECTORY_STEPS},
    tolerance::{
        TRAJECTORY_FIRST_SHARE, TRAJECTORY_LOOK_SHARE, TRAJECTORY_REFINEMENT, TRAJECTORY_RELATIVE,
        TRAJECTORY_STEP_RELATIVE,
    },
    work,
};

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

/// Why there is no trajectory.
///
/// ```
/// use virote_kernel::{TrajectoryError, find_trajectory};
///
/// // y' = y² from 1 is beyond all numbers at 1.
/// let found = find_trajectory(|_, y| Ok::<_, ()>(vec![y[0] * y[0]]), &[1.0], [0.0, 2.0], 1e-6);
/// assert!(matches!(found, Err(TrajectoryError::Ends { at, .. }) if (at - 1.0).abs() < 1e-6));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum TrajectoryError<E> {
    /// The function fails wherever the trajectory could go on.
    Function(E),
    /// Steps shrink to nothing: the state grows without bound, or its rate jumps or is no number.
    Ends {
        /// Where.
        at: f64,
        /// The state there.
        state: Vec<f64>,
    },
    /// It takes more than `TRAJECTORY_STEPS`.
    Long {
        /// Where the last of them ended.
        at: f64,
        /// Whether they are far shorter than the state needs, which changes slowly: the equation is stiff.
        is_stiff: bool,
    },
    /// With shorter steps it is another one.
    Unsettled {
        /// Where they differ most.
        at: f64,
        /// By how much.
        error: f64,
    },
}

/// Steps at least, so that none passes over what happens in its midst.
const LEAST_STEPS: f64 = 16.0;

/// Numbers between the ends of a step at least: the places inside are no longer apart in less.
const LEAST_SPACINGS: f64 = 64.0;

/// The trajectory of a state from `start`, at the first end of a range, `start` below `end`, to the other one, where `rate`
/// tells how it changes at a place. It is within `tolerance` in each component, or a millionth of a millionth
/// of its size if that is more, as far as two trajectories tell of which one has far smaller errors in each
/// step.
///
/// Dormand & Prince's method of order five, with steps that keep its difference from order four small.
/// A step at whose places the function fails is tried again shorter. Hairer, Nørsett & Wanner, *Solving
/// Ordinary Differential Equations I*, §II.4, §II.5; *II*, §IV.2 for stiffness.
///
/// ```
/// use virote_kernel::{TrajectoryError, find_trajectory};
///
/// // A point that turns about the origin.
/// let rate = |_: f64, p: &[f64]| Ok::<_, ()>(vec![-p[1], p[0]]);
/// let found = find_trajectory(rate, &[1.0, 0.0], [0.0, std::f64::consts::PI], 1e-10)?;
/// let end = found.at(std::f64::consts::PI);
/// assert!((end[0] + 1.0).abs() < 1e-10 && end[1].abs() < 1e-10);
/// # Ok::<(), TrajectoryError<()>>(())
/// ```
///
/// # Errors
/// [`TrajectoryError`] by what goes wrong, with the place.
pub fn find_trajectory<E>(
    mut rate: impl FnMut(f64, &[f64]) -> Result<Vec<f64>, E>,
    start: &[f64],
    range: [f64; 2],
    tolerance: f64,
) -> Result<Trajectory, TrajectoryError<E>> {
    let mut n_evaluations = 0;
    let mut rate = |place: f64, state: &[f64]| {
        n_evaluations += 1;
        rate(place, state)
    };
    let mut share = TRAJECTORY_FIRST_SHARE;
    let mut coarse = trajectory(&mut rate, start, range, [tolerance, share])?;
    let (mut at, mut error) = (range[0], f64::INFINITY);
    for _ in 0..TRAJECTORY_REFINEMENTS {
        share *= TRAJECTORY_REFINEMENT;
        let mut fine = match trajectory(&mut rate, start, range, [tolerance, share]) {
            Err(TrajectoryError::Long { .. }) if error.is_finite() => break,
            found => found?,
        };
        let size;
        (at, error, size) = coarse.apart(&fine);
        if error <= tolerance.max(TRAJECTORY_RELATIVE * size) {
            (fine.error, fine.n_evaluations) = (error, n_evaluations);
            return Ok(fine);
        }
        coarse = fine;
    }
    Err(TrajectoryError::Unsettled { at, error })
}

/// The trajectory with errors in each step of this share of the tolerance.
fn trajectory<E>(
    rate: &mut impl FnMut(f64, &[f64]) -> Result<Vec<f64>, E>,
    start: &[f64],
    [from, to]: [f64; 2],
    [tolerance, share]: [f64; 2],
) -> Result<Trajectory, TrajectoryError<E>> {
    let most = (to - from) / LEAST_STEPS;
    let beside = from.abs().max(to.abs());
    let spacing = beside.next_up() - beside;
    let least = (TRAJECTORY_STEP_RELATIVE * (to - from)).max(LEAST_SPACINGS * spacing);
    let allowed = |size: f64| share * tolerance.max(TRAJECTORY_RELATIVE * size);
    let first = rate(from, start).map_err(TrajectoryError::Function)?;
    let mut last = Step { place: from, state: start.to_vec(), rate: first };
    let mut steps = Vec::new();
    let (mut width, mut was_refused, mut stiffness) = (most, false, Stiffness::default());
    while last.place < to {
        // Two steps in the place of one and a rest.
        let left = to - last.place;
        let is_last = left <= width;
        width = if left < 2.0 * width { 0.5 * left } else { width };
        width = if is_last { left } else { width };
        let trial = Trial::new(rate, &last, if is_last { to } else { last.place + width });
        let error = trial.as_ref().map_or(f64::INFINITY, |trial| trial.error(&last.state, allowed));
        let growth = Trial::growth(error, was_refused);
        // Beside a jump of the rate the shortest step may be off by more.
        let is_shortest = width <= least;
        let most_error = if is_shortest { TRAJECTORY_FIRST_SHARE / share } else { 1.0 };
        was_refused = most_error < error;
        match trial {
            Ok(trial) if !was_refused => {
                stiffness.note(trial.stiffness);
                let at = trial.step.place;
                let goes_on = work::push(&mut steps, std::mem::replace(&mut last, trial.step))
                    && work::passes(STATES_A_STEP * start.len());
                if TRAJECTORY_STEPS < steps.len() || !goes_on {
                    return Err(TrajectoryError::Long { at, is_stiff: stiffness.is_stiff() });
                }
            }
            trial if is_shortest => {
                let Step { place: at, state, .. } = last;
                let ended = |_| TrajectoryError::Ends { at, state };
                return Err(trial.map_or_else(TrajectoryError::Function, ended));
            }
            _ => {}
        }
        width = (growth * width).clamp(least, most);
    }
    steps.push(last);
    with_second_derivatives(rate, steps)
}

/// Copies of the state that a step makes.
const STATES_A_STEP: usize = 20;

/// Whether steps are as short as they are for stability alone.
#[derive(Default)]
struct Stiffness {
    n_short: usize,
    n_free: usize,
}

impl Stiffness {
    /// Notes a step by its width as a multiple of the fastest change.
    fn note(&mut self, stiffness: f64) {
        /// Where the method stops being stable along the negative axis.
        const STABLE: f64 = 3.25;
        /// Steps that are free before the others are forgotten.
        const FREE: usize = 6;
        if STABLE < stiffness {
            self.n_short += 1;
            self.n_free = 0;
        } else {
            self.n_free += 1;
            if self.n_free == FREE {
                self.n_short = 0;
            }
        }
    }

    fn is_stiff(&self) -> bool {
        /// Steps that say so.
        const SHORT: usize = 15;
        SHORT <= self.n_short
    }
}

/// The nodes with their second derivatives: the change of the rate along the trajectory in the wider of the
/// steps beside each, where it counts most. In the narrower one the rate may jump.
fn with_second_derivatives<E>(
    rate: &mut impl FnMut(f64, &[f64]) -> Result<Vec<f64>, E>,
    steps: Vec<Step>,
) -> Result<Trajectory, TrajectoryError<E>> {
    let mut nodes = Vec::with_capacity(steps.len());
    for (idx, node) in steps.iter().enumerate() {
        let before = idx.checked_sub(1).and_then(|idx| steps.get(idx));
        let width = |other: &Step| (other.place - node.place).abs();
        let beside = [before, steps.get(idx + 1)].into_iter().flatten();
        let wider = beside.max_by(|a, b| width(a).total_cmp(&width(b)));
        let Some(wider) = wider else { unreachable!("a trajectory has a step or more") };
        let look = TRAJECTORY_LOOK_SHARE * (wider.place - node.place);
        let mut ask =
            |place| rate(place, &node.cubic(wider, place)).map_err(TrajectoryError::Function);
        let (near, far) = (ask(node.place + look)?, ask(node.place + 2.0 * look)?);
        let change = |i: usize| 4.0 * near[i] - 3.0 * node.rate[i] - far[i];
        let second = (0..node.state.len()).map(|i| change(i) / (2.0 * look)).collect();
        let Step { place, state, rate } = node.clone();
        nodes.push(TrajectoryNode { place, state, rate, second });
    }
    Ok(Trajectory { nodes, error: 0.0, n_evaluations: 0 })
}

impl Trajectory {
    /// The state at a place; beyond the range the first and last quintic go on.
    #[must_use]
    pub fn at(&self, place: f64) -> Vec<f64> {
        let behind = self.nodes.partition_point(|node| node.place <= place);
        let behind = behind.clamp(1, self.nodes.len() - 1);
        let (a, b) = (&self.nodes[behind - 1], &self.nodes[behind]);
        let width = b.place - a.place;
        let s = (place - a.place) / width;
        let [to_a, to_b] = [quintics(1.0 - s), quintics(s)];
        let state = |i: usize| {
            to_a[0] * a.state[i]
                + to_b[0] * b.state[i]
                + width * (to_b[1] * b.rate[i] - to_a[1] * a.rate[i])
                + width * width * (to_a[2] * a.second[i] + to_b[2] * b.second[i])
        };
        (0..a.state.len()).map(state).collect()
    }

    /// Where two differ most at the nodes of the other one and halfway between, by how much, and how large they
    /// are.
    fn apart(&self, other: &Self) -> (f64, f64, f64) {
        let (mut at, mut error, mut size) = (f64::NAN, 0.0_f64, 0.0_f64);
        let middles = other.nodes.windows(2).map(|pair| 0.5 * (pair[0].place + pair[1].place));
        for place in other.nodes.iter().map(|node| node.place).chain(middles) {
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

#[cfg(test)]
mod tests {
    use super::{TrajectoryError, find_trajectory, quintics};

    #[test]
    fn quintics_are_those_of_hermite() {
        // s⁵ has the value 1 at 1, the slope 5 and the second derivative 20, and none of these at 0.
        for s in [0.0, 0.3, 0.5, 0.9, 1.0] {
            let [value, slope, second] = quintics(s);
            assert!((value + 5.0 * slope + 20.0 * second - s * s * s * s * s).abs() < 1e-15);
        }
    }

    #[test]
    fn what_is_no_number_ends_at_once() {
        let mut n_asked = 0;
        let rate = |_: f64, _: &[f64]| {
            n_asked += 1;
            Ok::<_, ()>(vec![f64::NAN])
        };
        let found = find_trajectory(rate, &[0.0], [2.0, 3.0], 1e-6);
        let Err(TrajectoryError::Ends { at, state }) = found else { unreachable!("{found:?}") };
        assert_eq!((at.to_bits(), state), (2.0_f64.to_bits(), vec![0.0]));
        assert!(n_asked < 200, "{n_asked}");
    }

    #[test]
    fn a_function_that_fails_tells_the_place_to_which_it_does_not() {
        let rate = |t: f64, _: &[f64]| if t < 0.7 { Ok(vec![1.0]) } else { Err(t) };
        let found = find_trajectory(rate, &[0.0], [0.0, 1.0], 1e-6);
        assert!(
            matches!(found, Err(TrajectoryError::Function(t)) if (t - 0.7).abs() < 1e-9),
            "{found:?}"
        );
    }
}
