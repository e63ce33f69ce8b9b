//! Newton's method, and the iterations that keep it safe.
//!
//! What a step is made of (tangents, second derivatives, a linear system) its caller knows; here is
//! how steps follow one another: within limits, within a bracket of the root, or shortened until
//! they lead somewhere better. Dennis & Schnabel, *Numerical Methods for Unconstrained Optimization
//! and Nonlinear Equations*, §2.5 and §6.3; Press et al., *Numerical Recipes*, §9.4.

use std::{convert::Infallible, ops::ControlFlow};

use glam::DVec3;

/// What is done at a place.
#[derive(Clone, Copy, Debug)]
pub(crate) enum NewtonStep<const N: usize> {
    /// To go on by this.
    By([f64; N]),
    /// To go by this and stay there.
    Last([f64; N]),
    /// To stay: nothing is missing here.
    Stay,
    /// To give up: no step leads further.
    Stuck,
}

impl<const N: usize> NewtonStep<N> {
    /// A step that there may be.
    pub(crate) fn perhaps(step: Option<[f64; N]>) -> Self {
        step.map_or(Self::Stuck, Self::By)
    }
}

/// The step of a parameter to the foot, on the tangent there, of a point that is `away` from the
/// curve's: Newton's method for the nearest point but for the curve's bend.
pub(crate) fn to_foot(away: DVec3, velocity: DVec3) -> NewtonStep<1> {
    let step = away.dot(velocity) / velocity.length_squared();
    NewtonStep::perhaps(step.is_finite().then_some([step]))
}

/// Where an iteration ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum NewtonResult<const N: usize> {
    /// At rest.
    Settled([f64; N]),
    /// Still on its way when its steps were used up.
    Unsettled([f64; N]),
    /// Without a step.
    Stuck([f64; N]),
}

impl<const N: usize> NewtonResult<N> {
    /// The last place, however it was reached.
    pub(crate) fn place(self) -> [f64; N] {
        match self {
            Self::Settled(place) | Self::Unsettled(place) | Self::Stuck(place) => place,
        }
    }

    /// The last place, unless there was no step from it.
    pub(crate) fn unless_stuck(self) -> Option<[f64; N]> {
        match self {
            Self::Settled(place) | Self::Unsettled(place) => Some(place),
            Self::Stuck(_) => None,
        }
    }

    /// The place at which it came to rest.
    pub(crate) fn settled(self) -> Option<[f64; N]> {
        match self {
            Self::Settled(place) => Some(place),
            Self::Unsettled(_) | Self::Stuck(_) => None,
        }
    }
}

/// Unknowns without limits.
pub(crate) const FREE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

/// Newton's method from a place, each unknown kept within its limits: at rest where a step says so
/// or moves from one place to the next by so little that `is_still`.
pub(crate) fn within_limits<const N: usize>(
    limits: [[f64; 2]; N],
    start: [f64; N],
    most_steps: usize,
    is_still: impl Fn([f64; N], [f64; N]) -> bool,
    mut step: impl FnMut([f64; N]) -> NewtonStep<N>,
) -> NewtonResult<N> {
    let Ok(found) =
        try_within_limits(limits, start, most_steps, is_still, |at| Ok::<_, Infallible>(step(at)));
    found
}

/// [`within_limits`] by steps that may fail.
///
/// # Errors
/// Those of `step`.
pub(crate) fn try_within_limits<const N: usize, E>(
    limits: [[f64; 2]; N],
    start: [f64; N],
    most_steps: usize,
    is_still: impl Fn([f64; N], [f64; N]) -> bool,
    mut step: impl FnMut([f64; N]) -> Result<NewtonStep<N>, E>,
) -> Result<NewtonResult<N>, E> {
    let mut at = start;
    let moved = |at: [f64; N], step: [f64; N]| {
        std::array::from_fn(|i| (at[i] + step[i]).clamp(limits[i][0], limits[i][1]))
    };
    for _ in 0..most_steps {
        let next: [f64; N] = match step(at)? {
            NewtonStep::By(step) => moved(at, step),
            NewtonStep::Last(step) => return Ok(NewtonResult::Settled(moved(at, step))),
            NewtonStep::Stay => return Ok(NewtonResult::Settled(at)),
            NewtonStep::Stuck => return Ok(NewtonResult::Stuck(at)),
        };
        if is_still(at, next) {
            return Ok(NewtonResult::Settled(next));
        }
        at = next;
    }
    Ok(NewtonResult::Unsettled(at))
}

/// The root of a function inside of a bracket that begins where it is negative and ends where it is
/// not: Newton's method from `start`, and the middle of what is left of the bracket where a step
/// leads out of it.
///
/// `value_and_slope` may end the search at a place by telling nothing there.
pub(crate) fn within_bracket(
    bracket: [f64; 2],
    start: f64,
    most_steps: usize,
    is_still: impl Fn(f64, f64) -> bool,
    mut value_and_slope: impl FnMut(f64) -> Option<[f64; 2]>,
) -> f64 {
    let Ok(root) = try_within_bracket(bracket, start, most_steps, is_still, |t| {
        Ok::<_, Infallible>(value_and_slope(t))
    });
    root
}

/// [`within_bracket`] of a function that may fail.
///
/// # Errors
/// Those of `value_and_slope`.
pub(crate) fn try_within_bracket<E>(
    [mut low, mut high]: [f64; 2],
    start: f64,
    most_steps: usize,
    is_still: impl Fn(f64, f64) -> bool,
    mut value_and_slope: impl FnMut(f64) -> Result<Option<[f64; 2]>, E>,
) -> Result<f64, E> {
    let mut t = start;
    for _ in 0..most_steps {
        let Some([value, slope]) = value_and_slope(t)? else { return Ok(t) };
        if value < 0.0 {
            low = t;
        } else {
            high = t;
        }
        let newton = t - value / slope;
        let next = if low < newton && newton < high { newton } else { 0.5 * (low + high) };
        if is_still(t, next) {
            return Ok(next);
        }
        t = next;
    }
    Ok(t)
}

/// What a step, or the half of one and so on, led to first; `trial` breaks with that, or with
/// nothing where halves do not help.
///
/// # Errors
/// Those of `trial`.
pub(crate) fn shortened<const N: usize, T, E>(
    mut step: [f64; N],
    most_trials: usize,
    mut trial: impl FnMut([f64; N]) -> Result<ControlFlow<Option<T>>, E>,
) -> Result<Option<T>, E> {
    for _ in 0..most_trials {
        if let ControlFlow::Break(found) = trial(step)? {
            return Ok(found);
        }
        step = step.map(|x| 0.5 * x);
    }
    Ok(None)
}

/// The best that is known, made better as long as `better` finds something, `most_steps` times at
/// most.
///
/// # Errors
/// Those of `better`.
pub(crate) fn improved<T, E>(
    start: T,
    most_steps: usize,
    mut better: impl FnMut(&T) -> Result<Option<T>, E>,
) -> Result<T, E> {
    let mut best = start;
    for _ in 0..most_steps {
        match better(&best)? {
            Some(next) => best = next,
            None => break,
        }
    }
    Ok(best)
}

#[cfg(test)]
#[expect(clippy::float_cmp, reason = "exactness is the claim")]
mod tests {
    use std::{convert::Infallible, ops::ControlFlow};

    use glam::DVec3;

    use super::{
        FREE, NewtonResult, NewtonStep, improved, shortened, to_foot, within_bracket, within_limits,
    };

    type Never<T> = Result<T, Infallible>;

    /// √2, as the root of t² − 2.
    fn towards_root_of_two([t]: [f64; 1]) -> NewtonStep<1> {
        NewtonStep::By([(2.0 - t * t) / (2.0 * t)])
    }

    #[test]
    fn correct_digits_double_with_each_step() {
        let mut error = 0.5;
        for n in 1..5 {
            let found = within_limits([FREE], [1.5], n, |_, _| false, towards_root_of_two);
            let [t] = found.place();
            assert_eq!(found, NewtonResult::Unsettled([t]));
            // e' = e² / 2t.
            let next = (t - 2.0_f64.sqrt()).abs();
            assert!(next <= 0.5 * error * error + 1e-15, "{next} after {error}");
            error = next;
        }
    }

    #[test]
    fn limits_hold_and_a_place_on_them_is_at_rest() {
        let limits = [[1.45, 2.0]];
        let is_still = |last, next| last == next;
        let found = within_limits(limits, [1.5], 20, is_still, towards_root_of_two);
        assert_eq!(found.settled(), Some([1.45]));
    }

    #[test]
    fn two_unknowns_meet_on_a_circle_and_a_line() {
        // x² + y² = 25, x + 1 = y.
        let found = within_limits(
            [FREE; 2],
            [2.0, 5.0],
            20,
            |last: [f64; 2], next| last == next,
            |[x, y]| {
                let [circle, line] = [x * x + y * y - 25.0, x + 1.0 - y];
                let determinant = -2.0 * x - 2.0 * y;
                let dx = (circle + 2.0 * y * line) / determinant;
                let dy = (circle - 2.0 * x * line) / determinant;
                NewtonStep::By([dx, dy])
            },
        );
        assert_eq!(found.unless_stuck(), Some([3.0, 4.0]));
    }

    #[test]
    fn the_foot_on_a_line_is_one_step_away() {
        let (start, velocity) = (DVec3::new(1.0, 0.0, 2.0), DVec3::new(0.0, 2.0, 0.0));
        let found = within_limits(
            [FREE],
            [9.0],
            1,
            |_, _| false,
            |[t]| to_foot(DVec3::new(5.0, 3.0, 7.0) - (start + velocity * t), velocity),
        );
        assert_eq!(found.place(), [1.5]);
        assert!(matches!(to_foot(DVec3::X, DVec3::ZERO), NewtonStep::Stuck));
    }

    #[test]
    fn who_is_stuck_has_not_settled() {
        let stuck = within_limits([FREE], [7.0], 3, |_, _| true, |_| NewtonStep::Stuck);
        assert_eq!((stuck.settled(), stuck.unless_stuck(), stuck.place()), (None, None, [7.0]));
        let still = within_limits([FREE], [7.0], 3, |_, _| true, |_| NewtonStep::Stay);
        assert_eq!(still.settled(), Some([7.0]));
        let last = within_limits([FREE], [7.0], 3, |_, _| false, |_| NewtonStep::Last([1.0]));
        assert_eq!(last.settled(), Some([8.0]));
    }

    #[test]
    fn a_bracket_holds_where_newton_alone_runs_away() {
        // The steps of Newton's method on atan from 3 grow without end.
        let root = within_bracket(
            [-5.0, 40.0],
            3.0,
            100,
            |last, next| last == next,
            |t| Some([libm::atan(t), 1.0 / (1.0 + t * t)]),
        );
        assert!(root.abs() < 1e-15, "{root}");
    }

    #[test]
    fn a_bracket_with_a_jump_ends_at_it() {
        let jump = std::f64::consts::FRAC_1_SQRT_2;
        let root = within_bracket(
            [0.0, 1.0],
            0.5,
            100,
            |last, next| last == next,
            |t| Some([if t < jump { -1.0 } else { 1.0 }, 0.0]),
        );
        assert!((root - jump).abs() <= f64::EPSILON, "{root}");
    }

    #[test]
    fn a_step_is_halved_until_it_leads_down() {
        // From 1 down |t|, by a step of 16: 1 − 16 / 2ⁿ is nearer to zero first for n = 4.
        let Ok(next) = shortened([-16.0], 10, |[step]| {
            let next: f64 = 1.0 + step;
            Never::Ok(match next.abs() < 1.0 {
                true => ControlFlow::Break(Some(next)),
                false => ControlFlow::Continue(()),
            })
        });
        assert_eq!(next, Some(0.0));
        let Ok(none) =
            shortened([1.0], 10, |_| Never::Ok(ControlFlow::<Option<f64>>::Continue(())));
        assert_eq!(none, None);
    }

    #[test]
    fn the_best_is_what_nothing_is_better_than() {
        let halved = |t: &f64| Never::Ok(Some(0.5 * t).filter(|half| 1.0 < *half));
        let Ok(best) = improved(100.0, 60, halved);
        assert_eq!(best, 100.0 / 64.0);
        let Ok(best) = improved(100.0, 2, halved);
        assert_eq!(best, 25.0);
    }

    #[test]
    fn where_the_slope_is_vertical_the_bracket_is_halved() {
        // √t − 1/2 from t = 0, where Newton's step is none.
        let root = |t: f64| Some([t.sqrt() - 0.5, 0.5 / t.sqrt()]);
        let found = within_bracket([0.0, 1.0], 0.0, 60, |last, next| last == next, root);
        assert!((found - 0.25).abs() < 1e-15, "{found}");
    }
}
