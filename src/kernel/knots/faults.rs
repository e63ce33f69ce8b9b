//! What is wrong with knots that are refused.

use crate::{GeomError, InputError, KnotError};

/// What is wrong with knots of which some are not finite, or before their predecessor.
pub(super) fn disorder(knots: &[f64]) -> GeomError {
    if let Some(index) = knots.iter().position(|knot| !knot.is_finite()) {
        return InputError::NotFinite { what: "knot", index }.into();
    }
    let unsorted = knots.windows(2).position(|pair| pair[1] < pair[0]).unwrap_or(0);
    let (previous, knot) = (knots[unsorted], knots[unsorted + 1]);
    KnotError::UnsortedKnots { index: unsorted + 1, previous, knot }.into()
}

/// # Errors
/// [`KnotError::KnotMultiplicity`] for more than p + 1 at one place.
pub(super) fn check_multiplicities(degree: usize, knots: &[f64]) -> Result<(), GeomError> {
    let is_same = |a: &f64, b: &f64| a.total_cmp(b).is_eq();
    // They are sorted.
    let mut ends = knots.iter().zip(&knots[degree + 1..]);
    let Some(index) = ends.position(|(first, last)| is_same(first, last)) else { return Ok(()) };
    let knot = knots[index];
    let times = knots[index..].iter().take_while(|other| is_same(other, &knot)).count();
    Err(KnotError::KnotMultiplicity { index, knot, times, most: degree + 1 }.into())
}
