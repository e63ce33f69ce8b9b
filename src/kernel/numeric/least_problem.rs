//! What a search for a least value is given, and how it ends.

/// Where a search for the least value of several unknowns begins, and where it may go.
///
/// ```
/// use virote_kernel::{Answers, LeastEnd, LeastProblem};
///
/// // The point of the line x + y = 2 nearest to the origin, not beyond x = 0.5.
/// let functions = |x: &[f64], _| Ok::<_, ()>(Answers::from(vec![x[0] * x[0] + x[1] * x[1], x[0] + x[1] - 2.0]));
/// let problem = LeastProblem { start: &[0.0, 0.0], bounds: &[[-1.0, 0.5], [-9.0, 9.0]], n_equations: 1 };
/// let found = problem.find(functions)?;
/// assert_eq!(found.end, LeastEnd::Settled);
/// assert!((found.unknowns[0] - 0.5).abs() < 1e-9 && (found.unknowns[1] - 1.5).abs() < 1e-9);
/// # Ok::<(), ()>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct LeastProblem<'a> {
    /// The unknowns where the search begins.
    pub start: &'a [f64],
    /// Between which numbers each of them stays; infinite where nothing bounds it.
    pub bounds: &'a [[f64; 2]],
    /// How many of the functions behind the first one are to be zero; those behind them are not to be
    /// negative.
    pub n_equations: usize,
}

/// Why a search for a least value ended.
///
/// ```
/// use virote_kernel::{Answers, LeastEnd, LeastProblem};
///
/// let free = [f64::NEG_INFINITY, f64::INFINITY];
/// let problem = LeastProblem { start: &[1.0], bounds: &[free], n_equations: 0 };
/// let found = problem.find(|x, _| Ok::<_, ()>(Answers::from(vec![x[0]])))?;
/// assert_eq!(found.end, LeastEnd::Unbounded);
/// # Ok::<(), ()>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LeastEnd {
    /// No place near by is better.
    Settled,
    /// The function falls as far as the search went.
    Unbounded,
    /// The function falls by less and less as far as the search went, so that it has no least value or only tends to it.
    Unattained,
    /// The function falls without bound near the place.
    Pole,
    /// The conditions do not hold together near by.
    Contradictory,
    /// The function is the same all around the start.
    Flat,
    /// Places beside its end are better again and again.
    Unsettled,
}

impl LeastProblem<'_> {
    /// By how much each condition is broken.
    pub(super) fn broken(&self, values: &[f64]) -> impl Iterator<Item = f64> {
        let n_equations = self.n_equations;
        values[1..].iter().enumerate().map(move |(idx, value)| {
            if idx < n_equations { value.abs() } else { (-value).max(0.0) }
        })
    }
}
