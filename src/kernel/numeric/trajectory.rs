//! What a state comes to that changes at a known rate: initial values of ordinary differential equations.

use super::{
    branched_rate::{BranchEnd, BranchedRate, CountedRate, OneBranch},
    dormand_prince::{Step, TrialStep},
    trajectory_nodes::{Trajectory, TrajectoryNode},
};
use crate::{
    ceiling::{TRAJECTORY_REFINEMENTS, TRAJECTORY_STEPS},
    tolerance::{
        TRAJECTORY_FIRST_SHARE, TRAJECTORY_LOOK_SHARE, TRAJECTORY_REFINEMENT, TRAJECTORY_RELATIVE,
        TRAJECTORY_STEP_RELATIVE,
    },
    work,
};

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

/// The same where a look between the places of such steps shows that one did: as short as the looks are apart.
const FINER_STEPS: f64 = 100.0;

/// Numbers between the ends of a step at least: the places inside are no longer apart in less.
const LEAST_SPACINGS: f64 = 64.0;

/// The trajectory of a state from `start`, at the first end of a range, `start` below `end`, to the other one, where `rate`
/// tells how it changes at a place. It is within `tolerance` in each component, or a millionth of a millionth
/// of its size if that is more, as far as two trajectories tell of which one has far smaller errors in each
/// step.
///
/// Dormand & Prince's method of order five, with steps that keep its difference from order four small. The rate
/// is looked at between their places as well, a hundredth of the range apart, and where it is another one there steps
/// are no longer than that. A step at whose places the function fails is tried again shorter. Hairer, Nørsett & Wanner, *Solving
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
    rate: impl FnMut(f64, &[f64]) -> Result<Vec<f64>, E>,
    start: &[f64],
    range: [f64; 2],
    tolerance: f64,
) -> Result<Trajectory, TrajectoryError<E>> {
    find_branched_trajectory(&mut OneBranch(rate), start, range, tolerance)
}

/// [`find_trajectory`] of a rate that tells where it goes another way, and what the state is beyond: steps end there.
///
/// # Errors
/// As for [`find_trajectory`].
pub fn find_branched_trajectory<E>(
    rate: &mut impl BranchedRate<E>,
    start: &[f64],
    range: [f64; 2],
    tolerance: f64,
) -> Result<Trajectory, TrajectoryError<E>> {
    let mut rate = CountedRate { rate, n_asked: 0 };
    let mut found = settled(&mut rate, start, range, [tolerance, LEAST_STEPS])?;
    if found.overlooks(&mut rate, range, tolerance) {
        found = settled(&mut rate, start, range, [tolerance, FINER_STEPS])?;
    }
    found.n_evaluations = rate.n_asked;
    Ok(found)
}

/// The trajectory that stays the same with smaller errors in each of so many steps or more.
fn settled<E>(
    rate: &mut impl BranchedRate<E>,
    start: &[f64],
    range: [f64; 2],
    [tolerance, least_steps]: [f64; 2],
) -> Result<Trajectory, TrajectoryError<E>> {
    let mut share = TRAJECTORY_FIRST_SHARE;
    let mut coarse = trajectory(rate, start, range, [tolerance, share, least_steps])?;
    let (mut at, mut error) = (range[0], f64::INFINITY);
    for _ in 0..TRAJECTORY_REFINEMENTS {
        share *= TRAJECTORY_REFINEMENT;
        let mut fine = match trajectory(rate, start, range, [tolerance, share, least_steps]) {
            Err(TrajectoryError::Long { .. }) if error.is_finite() => break,
            found => found?,
        };
        let size;
        (at, error, size) = coarse.apart(&fine);
        if error <= tolerance.max(TRAJECTORY_RELATIVE * size) {
            fine.error = error;
            return Ok(fine);
        }
        coarse = fine;
    }
    Err(TrajectoryError::Unsettled { at, error })
}

/// The trajectory with errors in each step of this share of the tolerance.
fn trajectory<E>(
    rate: &mut impl BranchedRate<E>,
    start: &[f64],
    [from, to]: [f64; 2],
    [tolerance, share, least_steps]: [f64; 3],
) -> Result<Trajectory, TrajectoryError<E>> {
    let most = (to - from) / least_steps;
    let beside = from.abs().max(to.abs());
    let spacing = beside.next_up() - beside;
    let least = (TRAJECTORY_STEP_RELATIVE * (to - from)).max(LEAST_SPACINGS * spacing);
    let allowed = |size: f64| share * tolerance.max(TRAJECTORY_RELATIVE * size);
    let first = rate.begin(from, start).map_err(TrajectoryError::Function)?;
    let mut last = Step { place: from, state: start.to_vec(), rate: first };
    let (mut steps, mut behind_jumps) = (Vec::new(), Vec::new());
    let (mut width, mut was_refused, mut stiffness) = (most, false, Stiffness::default());
    while last.place < to {
        // Two steps in the place of one and a rest.
        let left = to - last.place;
        let is_last = left <= width;
        width = if left < 2.0 * width { 0.5 * left } else { width };
        width = if is_last { left } else { width };
        let end = if is_last { to } else { last.place + width };
        let trial =
            TrialStep::new(&mut |place, state: &[f64]| rate.along(place, state), &last, end);
        let error = trial.as_ref().map_or(f64::INFINITY, |trial| trial.error(&last.state, allowed));
        let growth = TrialStep::growth(error, was_refused);
        // Beside a jump of the rate the shortest step may be off by more.
        let is_shortest = width <= least;
        let most_error = if is_shortest { TRAJECTORY_FIRST_SHARE / share } else { 1.0 };
        was_refused = most_error < error;
        let beyond_end = (end + width).min(to);
        width = (growth * width).clamp(least, most);
        let step = match trial {
            Ok(trial) if !was_refused => {
                stiffness.note(trial.stiffness);
                trial.step
            }
            Ok(_) if is_shortest => {
                return Err(TrajectoryError::Ends { at: last.place, state: last.state });
            }
            Err(failed) if is_shortest => {
                behind_jumps.push(steps.len() + 1);
                (width, was_refused) = (most, false);
                beyond(rate, failed, &last, beyond_end).map_err(TrajectoryError::Function)?
            }
            _ => continue,
        };
        let at = step.place;
        let goes_on = work::push(&mut steps, std::mem::replace(&mut last, step))
            && work::passes(STATES_A_STEP * start.len());
        if TRAJECTORY_STEPS < steps.len() || !goes_on {
            return Err(TrajectoryError::Long { at, is_stiff: stiffness.is_stiff() });
        }
    }
    steps.push(last);
    with_second_derivatives(rate, &steps, &behind_jumps)
}

/// The step over a place at which the rate goes another way.
fn beyond<E>(rate: &mut impl BranchedRate<E>, failed: E, from: &Step, to: f64) -> Result<Step, E> {
    let branch_end = BranchEnd { place: from.place, state: &from.state, rate: &from.rate };
    let state = rate.beyond(failed, branch_end, to)?;
    let rate = rate.begin(to, &state)?;
    Ok(Step { place: to, state, rate })
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
    rate: &mut impl BranchedRate<E>,
    steps: &[Step],
    behind_jumps: &[usize],
) -> Result<Trajectory, TrajectoryError<E>> {
    let mut nodes = Vec::with_capacity(steps.len());
    for (idx, node) in steps.iter().enumerate() {
        let before = idx.checked_sub(1).and_then(|idx| steps.get(idx));
        // Over a jump there is no change that counts.
        let width = |other: &Step| {
            let behind = if other.place < node.place { idx } else { idx + 1 };
            let is_jump = behind_jumps.binary_search(&behind).is_ok();
            if is_jump { 0.0 } else { (other.place - node.place).abs() }
        };
        let beside = [before, steps.get(idx + 1)].into_iter().flatten();
        let wider = beside.max_by(|a, b| width(a).total_cmp(&width(b)));
        let Some(wider) = wider else { unreachable!("a trajectory has a step or more") };
        let look = TRAJECTORY_LOOK_SHARE * (wider.place - node.place);
        let mut ask =
            |place| rate.at(place, &node.cubic(wider, place)).map_err(TrajectoryError::Function);
        let (near, far) = (ask(node.place + look)?, ask(node.place + 2.0 * look)?);
        let change = |i: usize| 4.0 * near[i] - 3.0 * node.rate[i] - far[i];
        let second = (0..node.state.len()).map(|i| change(i) / (2.0 * look)).collect();
        let Step { place, state, rate } = node.clone();
        nodes.push(TrajectoryNode { place, state, rate, second });
    }
    let jumps = behind_jumps.iter().map(|&idx| [steps[idx - 1].place, steps[idx].place]).collect();
    Ok(Trajectory { nodes, error: 0.0, n_evaluations: 0, jumps })
}

/// Between these parts of a step its places are farther apart than behind them; that at a fifth counts for no state.
const GAPS: [[f64; 2]; 2] = [[0.0, 0.3], [0.3, 0.8]];

impl Trajectory {
    /// Whether between the places of its steps the rate is another one than along the trajectory, by so much that it
    /// would change it by more than the tolerance over the distance of looks; or whether there is none.
    fn overlooks<E>(
        &self,
        rate: &mut impl BranchedRate<E>,
        [from, to]: [f64; 2],
        tolerance: f64,
    ) -> bool {
        let apart = (to - from) / FINER_STEPS;
        let mut is_off = |place: f64| {
            let state = self.at(place);
            let size = state.iter().fold(0.0, |most: f64, part| most.max(part.abs()));
            let allowed = tolerance.max(TRAJECTORY_RELATIVE * size);
            let Ok(rates) = rate.at(place, &state) else { return true };
            let along = self.rate_at(place);
            !rates.iter().zip(&along).all(|(a, b)| (a - b).abs() * apart <= allowed)
        };
        self.nodes.windows(2).any(|pair| {
            let width = pair[1].place - pair[0].place;
            GAPS.iter().any(|[start, end]| {
                let n_parts = ((end - start) * width / apart).ceil().max(1.0) as usize;
                let share = |k| start + (end - start) * k as f64 / n_parts as f64;
                (1..n_parts).any(|k| is_off(pair[0].place + share(k) * width))
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::{TrajectoryError, find_trajectory};

    #[test]
    fn loads_on_a_hundredth_of_the_range_are_seen() {
        for width in [0.011, 0.02, 0.03, 0.05] {
            for k in 0..97 {
                let start = (1.0 - width) * f64::from(k) / 96.0;
                let mut n_asked = 0;
                let rate = |t: f64, _: &[f64]| {
                    n_asked += 1;
                    let is_loaded = start < t && t < start + width;
                    Ok::<_, ()>(vec![if is_loaded { 1.0 / width } else { 0.0 }])
                };
                let found = find_trajectory(rate, &[0.0], [0.0, 1.0], 1e-6);
                let end = found.map(|found| found.at(1.0)[0]);
                assert!(
                    end.as_ref().is_ok_and(|end| (end - 1.0).abs() < 1e-5),
                    "{width} {start} {end:?}"
                );
                assert!(n_asked < 20_000, "{n_asked}");
            }
        }
    }

    #[test]
    fn what_is_smooth_is_looked_at_no_longer() {
        let mut n_asked = 0;
        let rate = |t: f64, _: &[f64]| {
            n_asked += 1;
            Ok::<_, ()>(vec![2.0 * t])
        };
        assert!(find_trajectory(rate, &[0.0], [0.0, 6.0], 1e-6).is_ok());
        assert!(n_asked < 350, "{n_asked}");
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
