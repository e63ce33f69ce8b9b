//! Where a function goes another way, which its comparisons tell, between two places at which it was asked.

use crate::diag::Result;

/// Where between two places the function is asked, the second where it fails at the first.
const SHARES: [f64; 2] = [0.5, 0.4375];

/// All bits of a number, and of what is small beside it.
const HALVINGS: usize = 128;

/// The derivative at the end of four steps, by the values at all their ends.
pub(super) const END_SLOPE: [f64; 5] = [25.0 / 12.0, -4.0, 3.0, -4.0 / 3.0, 0.25];

/// Two places nearest to one another that the change lies between, each with what is found there: bisection between
/// two, where `is_first` tells whether the function goes at a place as at the first.
pub(super) fn bisected<T>(
    mut sides: [(f64, T); 2],
    mut ask: impl FnMut(f64) -> Result<T>,
    is_first: impl Fn(&T, &T) -> bool,
) -> [(f64, T); 2] {
    for _ in 0..HALVINGS {
        let [from, to] = [sides[0].0, sides[1].0];
        let is_apart = |at: f64, other: f64| at.total_cmp(&other).is_ne();
        let inside = SHARES.map(|share| from + share * (to - from)).into_iter();
        let mut inside = inside.filter(|&at| is_apart(at, from) && is_apart(at, to));
        // At the change itself there may be no derivative.
        let found = inside.find_map(|at| Some((at, ask(at).ok()?)));
        let Some(found) = found else { break };
        let side = usize::from(!is_first(&found.1, &sides[0].1));
        sides[side] = found;
    }
    sides
}
