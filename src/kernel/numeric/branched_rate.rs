//! How a state changes at a place, where that may go one way or another.

/// A rate at which a state changes, in branches: within each it is smooth, and what ends one is known.
///
/// A point that turns back at 1, each time with half of its speed:
///
/// ```
/// use virote_kernel::{BranchEnd, BranchedRate, find_branched_trajectory};
///
/// struct Wall;
///
/// impl BranchedRate<bool> for Wall {
///     fn at(&mut self, _: f64, state: &[f64]) -> Result<Vec<f64>, bool> {
///         Ok(vec![state[1], 0.0])
///     }
///
///     fn along(&mut self, place: f64, state: &[f64]) -> Result<Vec<f64>, bool> {
///         if state[0] < 1.0 || state[1] < 0.0 { self.at(place, state) } else { Err(true) }
///     }
///
///     fn beyond(&mut self, _: bool, end: BranchEnd<'_>, _: f64) -> Result<Vec<f64>, bool> {
///         Ok(vec![end.state[0], -0.5 * end.state[1]])
///     }
/// }
///
/// let found = find_branched_trajectory(&mut Wall, &[0.0, 1.0], [0.0, 3.0], 1e-9).expect("a trajectory");
/// assert!(found.at(3.0)[0].abs() < 1e-9);
/// ```
pub trait BranchedRate<E> {
    /// The rate at a place, whatever way it goes.
    ///
    /// # Errors
    /// Where there is none.
    fn at(&mut self, place: f64, state: &[f64]) -> Result<Vec<f64>, E>;

    /// The rate where a branch begins.
    ///
    /// # Errors
    /// Where there is none.
    fn begin(&mut self, place: f64, state: &[f64]) -> Result<Vec<f64>, E> {
        self.at(place, state)
    }

    /// The rate along the branch that was begun last.
    ///
    /// # Errors
    /// Where there is none, and where the branch has ended.
    fn along(&mut self, place: f64, state: &[f64]) -> Result<Vec<f64>, E> {
        self.at(place, state)
    }

    /// The state at a place a little behind the end of a branch, where the next one begins.
    ///
    /// # Errors
    /// Why the branch could not be followed, where that is not its end; why nothing is known beyond it.
    fn beyond(&mut self, failed: E, end: BranchEnd<'_>, to: f64) -> Result<Vec<f64>, E>;
}

/// The last place that is known of a branch.
///
/// ```
/// use virote_kernel::BranchEnd;
///
/// let end = BranchEnd { place: 0.5, state: &[2.0], rate: &[4.0] };
/// assert_eq!(end.state_after(0.25), [3.0]);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct BranchEnd<'a> {
    /// Where.
    pub place: f64,
    /// The state there.
    pub state: &'a [f64],
    /// Its rate.
    pub rate: &'a [f64],
}

impl BranchEnd<'_> {
    /// The state so far behind it, if it keeps its rate.
    #[must_use]
    pub fn state_after(&self, width: f64) -> Vec<f64> {
        self.state.iter().zip(self.rate).map(|(state, rate)| state + width * rate).collect()
    }
}

/// A rate that is told by a function alone.
pub(super) struct OneBranch<F>(pub(super) F);

impl<E, F: FnMut(f64, &[f64]) -> Result<Vec<f64>, E>> BranchedRate<E> for OneBranch<F> {
    fn at(&mut self, place: f64, state: &[f64]) -> Result<Vec<f64>, E> {
        (self.0)(place, state)
    }

    fn beyond(&mut self, failed: E, _: BranchEnd<'_>, _: f64) -> Result<Vec<f64>, E> {
        Err(failed)
    }
}

/// A rate that counts how often it is asked. Components that it does not tell are no numbers.
pub(super) struct CountedRate<'a, R> {
    pub(super) rate: &'a mut R,
    pub(super) n_asked: usize,
}

impl<E, R: BranchedRate<E>> BranchedRate<E> for CountedRate<'_, R> {
    fn at(&mut self, place: f64, state: &[f64]) -> Result<Vec<f64>, E> {
        self.n_asked += 1;
        self.rate.at(place, state).map(|rate| filled(rate, state.len()))
    }

    fn begin(&mut self, place: f64, state: &[f64]) -> Result<Vec<f64>, E> {
        self.n_asked += 1;
        self.rate.begin(place, state).map(|rate| filled(rate, state.len()))
    }

    fn along(&mut self, place: f64, state: &[f64]) -> Result<Vec<f64>, E> {
        self.n_asked += 1;
        self.rate.along(place, state).map(|rate| filled(rate, state.len()))
    }

    fn beyond(&mut self, failed: E, end: BranchEnd<'_>, to: f64) -> Result<Vec<f64>, E> {
        self.rate.beyond(failed, end, to).map(|state| filled(state, end.state.len()))
    }
}

/// As many components as there are.
fn filled(mut components: Vec<f64>, n: usize) -> Vec<f64> {
    components.resize(n, f64::NAN);
    components
}
